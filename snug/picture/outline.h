#pragma once

#include <vector>

#include "snug/picture/depth_image.h"
#include "snug/polygon/cell_loops.h"
#include "snug/polygon/polygon.h"

namespace snug {

/// A closed line, its last point joined to its first.
using Loop = std::vector<Vec2d>;

/// The outlines of a mask in cells (a cell is 1 x 1, the first spans 0 to 1): outer ones clockwise on the
/// page, holes the other way round. Cells that meet in a corner belong together. Stairs are smoothed within
/// half a cell; loops around fewer than `least_cells` cells are left out, unless all are: then the largest
/// stays.
[[nodiscard]] std::vector<Loop> outlines(const Mask& mask, double least_cells);

/// The loop with fewer points, nowhere farther than `tolerance` from it (Douglas and Peucker, 1973).
[[nodiscard]] Loop simplified(const Loop& loop, double tolerance);

}  // namespace snug
