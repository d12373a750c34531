#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"
#include "snug/object/cloud_places.h"

namespace snug {

/// Each point of a cloud counts as a ball, so that the balls together hide the surface between the points.
struct PointRadii {
    std::vector<float> radius;  ///< of each vertex, in the cloud's unit, greater than 0
    double median = 0;          ///< of `radius`
    std::size_t shortened = 0;  ///< points so far from all others that their radius was limited
};

/// The distance to the sixth-nearest other place where points lie (fewer where there are fewer): on a surface
/// sampled in squares that is twice what covers it, on one sampled at random still more than what covers it
/// nearly everywhere. At most four times the median, so that a stray point does not cut half the foam away.
/// Points in the same place count once, and ties cannot matter: only distances are used.
/// With `fixed` > 0 that for every point. Fails with kind `input` where all points are one, and with kind
/// `usage` where `fixed` is negative or not finite.
[[nodiscard]] Result<PointRadii> point_radii(const Mesh& cloud, const CloudPlaces& places, double fixed = 0);

}  // namespace snug
