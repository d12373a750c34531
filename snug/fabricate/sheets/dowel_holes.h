#pragma once

#include <vector>

#include "snug/design/sheet_options.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// Where dowels go through the sheets of a half.
struct DowelHoles {
    std::vector<Vec2d> centres;  ///< mm from the upper left corner of the half; none: no room anywhere
    int sheets = 0;              ///< that have them: the first ones from the case
};

/// The same holes in as many sheets as have room: what a sheet keeps all sheets below it keep as well. No
/// two distances between them are alike, and turned or mirrored within the half's rectangle at least one hole
/// misses the others by a dowel's diameter.
[[nodiscard]] DowelHoles dowel_holes(const SheetStack& stack, const SheetOptions& options);

/// Whether some hole of the set, turned by 180 degrees (by any quarter, for a square) or mirrored with the
/// rectangle, lies at least `least_mm` from every hole.
[[nodiscard]] bool one_way_only(const std::vector<Vec2d>& centres, Vec2d rectangle_mm, double least_mm);

}  // namespace snug
