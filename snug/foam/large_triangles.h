#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/foam/design_space.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Whether a triangle may meet so many columns that DepthTiles pay.
[[nodiscard]] bool is_large(const Triangle& triangle, std::span<const Vec3d> placed,
                            const DesignSpace& space);

/// The large triangles in the order in which they hide most of each other: the outermost along x first, and
/// of equal ones a single one. `placed`: the vertices.
[[nodiscard]] std::vector<std::uint32_t> large_triangles(std::span<const Triangle> triangles,
                                                         std::span<const Vec3d> placed,
                                                         const DesignSpace& space);

}  // namespace snug
