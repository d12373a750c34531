#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// The triangles that are marked, in the order in which they hide most of each other: the outermost along x
/// first, and of equal ones a single one. `placed`: the vertices.
[[nodiscard]] std::vector<std::uint32_t> outermost_first(std::span<const Triangle> triangles,
                                                         std::span<const std::uint8_t> marked,
                                                         std::span<const Vec3d> placed);

}  // namespace snug
