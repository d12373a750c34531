#pragma once

#include <array>

#include "snug/base/vec.h"
#include "snug/depth/depth_map.h"

namespace snug {

/// What a triangle reaches beside its vertices in neighbouring columns, where each of them is bounded, as far
/// as the triangle goes, by the sides that it turns to the others. The same operations as in DepthMapBuilder,
/// on several sides at a time. False, with nothing found, where a vertex lies on a side: it has two edges
/// there, which need not give it the same x.

/// Two columns: `sides` are the high one of the first and the low one of the second along the axis in which
/// they lie; `u` and `x` are the vertices' coordinates along it and along x.
[[nodiscard]] bool extremes_beside_side(const std::array<double, 3>& u, const std::array<double, 3>& x,
                                        const std::array<double, 2>& sides, std::array<DepthRange, 2>& found);

/// Four columns around a corner of the grid: (j, k), (j, k + 1), (j + 1, k), (j + 1, k + 1). `sides` are the
/// high one of row j, the low one of row j + 1, the high one of cell k and the low one of cell k + 1.
[[nodiscard]] bool extremes_around_corner(const std::array<Vec3d, 3>& corners,
                                          const std::array<double, 4>& sides,
                                          std::array<DepthRange, 4>& found);

}  // namespace snug
