#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "snug/base/result.h"
#include "snug/formats/affine.h"
#include "snug/formats/gltf_accessor.h"
#include "snug/formats/gltf_buffers.h"
#include "snug/formats/gltf_json.h"

namespace snug::gltf {

/// A scene's nodes: where each stands in the world, and which of them the scene shows that a viewer opens
/// with (glTF 2.0, section 3.5). Nothing here depends on how deep they nest.
class Nodes {
  public:
    [[nodiscard]] static Result<Nodes> open(const Json& scene);

    /// Fails where the node lies within itself, or within two others that place it differently: viewers do
    /// not agree on such.
    [[nodiscard]] Result<Affine> world(std::uint64_t node);
    /// The nodes that are seen, in the order of the file: of the default scene, the first where none is
    /// named, all where there is no scene. Fails where the scene lists a node that also lies within another
    /// which moves it: viewers do not agree on that either. KHR_node_visibility hides a node and what lies
    /// below it.
    [[nodiscard]] Result<std::vector<std::size_t>> shown();
    [[nodiscard]] const Json& json(std::uint64_t node) const { return item(*nodes_, node); }

  private:
    explicit Nodes(const Json& scene);
    [[nodiscard]] Result<void> link();
    [[nodiscard]] Result<Affine> first_world(std::size_t node);
    [[nodiscard]] Result<std::vector<std::size_t>> roots();

    const Json* scene_;
    const Json* nodes_;
    std::vector<std::size_t> parent_;  ///< the first; count of nodes for none
    std::map<std::size_t, std::vector<std::size_t>> further_parents_;
    enum class State : std::uint8_t { unknown, on_the_way, known };
    std::vector<State> state_;
    std::vector<Affine> world_;  ///< where known
};

/// Where a node repeats its mesh (EXT_mesh_gpu_instancing), in the node's own space; one place that changes
/// nothing where it does not.
class Instances {
  public:
    [[nodiscard]] static Result<Instances> open(const Json& scene, Buffers& buffers, const Json& node);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Numbers that are read for one place, as Primitive::effort() counts them.
    [[nodiscard]] std::uint64_t effort() const {
        return translation_.effort() + rotation_.effort() + scale_.effort();
    }
    /// i < count()
    [[nodiscard]] Affine at(std::uint64_t i) const;

  private:
    std::uint64_t count_ = 1;
    Accessor translation_, rotation_, scale_;  ///< without elements: the default
};

}  // namespace snug::gltf
