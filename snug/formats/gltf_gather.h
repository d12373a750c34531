#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/result.h"
#include "snug/formats/affine.h"
#include "snug/formats/gltf_primitive.h"
#include "snug/mesh/raw_mesh.h"

namespace snug::gltf {

/// Collects the triangles that placed primitives make. Only points that triangles use are taken over, so that
/// many primitives may share one list of points.
class Gatherer {
  public:
    /// Is told of a primitive and how often it will be added, before anything is: refused where a scene
    /// repeats what it holds far beyond its size. `per_copy`: as Primitive::effort(), to place one. `bytes`
    /// stand behind the scene.
    [[nodiscard]] Result<void> announce(const Primitive& primitive, std::uint64_t copies,
                                        std::uint64_t per_copy, std::uint64_t bytes);
    /// `place` takes the primitive's space to mm; with a pose, the joints' space.
    [[nodiscard]] Result<void> add(const Primitive& primitive, const Affine& place,
                                   const std::vector<Affine>* pose);
    [[nodiscard]] Result<Mesh> take() &&;

  private:
    [[nodiscard]] Result<void> add_points(const Primitive& primitive);
    [[nodiscard]] Result<void> add_triangles(const Primitive& primitive);
    [[nodiscard]] Result<void> add_triangle(const Primitive& primitive, std::uint64_t a, std::uint64_t b,
                                            std::uint64_t c);
    /// The number of a point in `raw_`; a point that is no number is none.
    [[nodiscard]] Result<std::optional<std::uint32_t>> vertex(const Primitive& primitive,
                                                              std::uint64_t point);
    [[nodiscard]] Result<Vec3d> placed(const Primitive& primitive, std::uint64_t point) const;

    Affine place_;
    const std::vector<Affine>* pose_ = nullptr;
    bool mirrored_ = false;
    RawMesh raw_;
    std::vector<Vec3d> points_;  ///< of primitives that are points
    ReadNotes notes_;
    std::uint64_t corners_ = 0, effort_ = 0;
    // Of each point of the primitive at hand: its number, valid where the stamp is this primitive's.
    std::vector<std::uint32_t> stamp_, number_;
    std::uint32_t now_ = 0;
};

}  // namespace snug::gltf
