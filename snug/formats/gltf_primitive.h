#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/formats/affine.h"
#include "snug/formats/gltf_accessor.h"
#include "snug/formats/gltf_buffers.h"
#include "snug/formats/gltf_draco.h"

namespace snug::gltf {

/// How a primitive's corners make triangles, as glTF numbers them.
enum class Topology { points = 0, triangles = 4, strip = 5, fan = 6 };

/// A primitive: its points as they are without movement, and the corners that name them.
struct Primitive {
    Topology topology = Topology::triangles;
    Accessor positions;
    struct Morph {
        Accessor offsets;
        double weight = 0;
    };
    std::vector<Morph> morphs;  ///< those that move anything
    struct Influence {
        Accessor joints, weights;
    };
    /// Four joints of the skin: the first set. Further sets are passed over, as glTF allows.
    std::optional<Influence> influence;
    std::optional<Accessor> indices;                ///< none: the points in their order
    std::span<const std::uint32_t> packed_corners;  ///< in place of them where Draco packed it

    [[nodiscard]] std::uint64_t corners() const;
    /// The point of a corner; none where a strip begins anew.
    [[nodiscard]] std::optional<std::uint64_t> corner(std::uint64_t i) const;
    /// point < positions.count(), with the morphs' share.
    [[nodiscard]] Vec3d point(std::uint64_t point) const;
    /// Where the joints take the point; none where a joint is not in the pose.
    [[nodiscard]] std::optional<Affine> skinned(std::uint64_t point, std::span<const Affine> pose) const;
    /// Numbers that are read for one corner.
    [[nodiscard]] std::uint64_t effort() const;
};

/// None where it has nothing that takes room: lines, or no positions. `weights`: of the morph targets.
[[nodiscard]] Result<std::optional<Primitive>> open_primitive(const Json& scene, Buffers& buffers,
                                                              DracoMeshes& draco, const Json& primitive,
                                                              std::span<const double> weights);

}  // namespace snug::gltf
