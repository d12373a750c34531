#pragma once

#include <cstdint>
#include <vector>

#include "snug/polygon/plan_region.h"

namespace snug {

/// A corner of an outline. Who walks from corner to corner has the area on the left-hand side, y to the front
/// and z to the left: counter-clockwise around the area, seen from +x.
struct OutlineCorner {
    PlanPoint at;
    std::uint32_t next = 0, previous = 0;
};

/// The corners of all outlines of a region, ascending by y, then z. The region must nowhere meet itself in a
/// mere point.
[[nodiscard]] std::vector<OutlineCorner> outline_corners(const PlanRegion& region);

/// Where the corners come to when the region grows by `by`, in their order. What lies on the box's sides
/// stays on them. Nothing may be so narrow that it closes.
[[nodiscard]] std::vector<PlanPoint> offset_corners(const std::vector<OutlineCorner>& corners, int by,
                                                    const PlanBox& box);

}  // namespace snug
