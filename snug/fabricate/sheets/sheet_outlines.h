#pragma once

#include <vector>

#include "snug/base/vec2.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// The line that a cutter's middle follows around cells, mm from the mask's upper left corner: every side
/// moved outward (into the waste) by half the kerf. Exact, and without crossings as long as the kerf is
/// smaller than a cell's sides.
[[nodiscard]] std::vector<Vec2d> cut_line(const CellLoop& loop, Vec2d cell_mm, double kerf_mm);

/// Where the sheet above ends on this piece, mm from the piece's mask, as open or closed (first point = last)
/// lines; what coincides with the piece's own outline is left out.
[[nodiscard]] std::vector<std::vector<Vec2d>> outline_above(const SheetStack& stack, const SheetPiece& piece);

[[nodiscard]] double loop_length(const std::vector<Vec2d>& loop);

}  // namespace snug
