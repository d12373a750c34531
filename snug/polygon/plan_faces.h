#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/polygon/plan_region.h"

namespace snug {

/// A place in plan where a vertex stands.
struct PlanVertex {
    PlanPoint at;
    std::uint32_t vertex = 0;
};

/// Appends the triangles of a region, with vertices wherever its outlines turn and wherever else one of
/// `vertices` stands on them; these ascend by y, then z, and those that do not meet the region are passed
/// over. `face` as in row_triangulator.h: 1 for a face that looks to +x, -1 for one that looks to -x.
void triangulate(const PlanRegion& region, std::span<const PlanVertex> vertices, int face,
                 std::vector<Triangle>& triangles);

}  // namespace snug
