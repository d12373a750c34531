#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/search/placement_search.h"

namespace snug {

/// A direction of insertion and the best that a glance finds for it.
struct MappedDirection {
    Vec3d direction;  ///< unit, as the object has it: what comes to point along +x
    FoundPlacement placement;
};

constexpr std::size_t kMapDirections = 800;

/// What is cut by direction, for a picture: directions spread evenly over half the sphere (its other half
/// cuts the same blocks), each with the least over twelve turns about x and all offsets within half a block,
/// by points of the surface (PlacementSearch::glance). Directions in which the object does not fit with its
/// walls are left out. Fails only when cancelled.
[[nodiscard]] Result<std::vector<MappedDirection>> direction_map(const PlacementSearch& search,
                                                                 std::size_t directions = kMapDirections,
                                                                 const Progress& progress = {});

}  // namespace snug
