#pragma once

#include <span>

#include "snug/depth/depth_map.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// The depth map of points that are balls (point_radius.h), one radius a vertex: the extremes of x over all
/// their points whose y and z lie in the column's cell grown by `reach`, bounds included. Exact: within a
/// cell a ball reaches furthest above the cell's nearest point to its centre. Takes as many steps as the
/// balls cover columns.
[[nodiscard]] DepthMap cloud_depth_map(const Mesh& cloud, std::span<const float> radius,
                                       const Placement& placement, const DesignSpace& space, Reach reach);

}  // namespace snug
