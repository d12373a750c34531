#pragma once

#include <vector>

#include "snug/base/vec2.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// An outline of cells, mm from the mask's upper left corner, with every side moved outward (into the waste)
/// by `offset_mm`: half the kerf for the line that a cutter's middle follows. Exact, and without crossings as
/// long as twice the offset is smaller than a cell's sides.
[[nodiscard]] std::vector<Vec2d> offset_outline(const CellLoop& loop, Vec2d cell_mm, double offset_mm);

/// Where the sheet above ends on this piece, mm from the piece's mask, as open or closed (first point = last)
/// lines; what coincides with the piece's own outline is left out.
[[nodiscard]] std::vector<std::vector<Vec2d>> outline_above(const SheetStack& stack, const SheetPiece& piece);

}  // namespace snug
