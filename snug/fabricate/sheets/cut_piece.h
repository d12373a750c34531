#pragma once

#include <span>
#include <vector>

#include "snug/design/sheet_options.h"
#include "snug/drawing/drawing.h"
#include "snug/fabricate/kit/item_labels.h"
#include "snug/fabricate/sheets/dowel_holes.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// A piece of foam as a cutter gets it, mm from the upper left corner of its cells.
struct CutPiece {
    std::vector<std::vector<Vec2d>> inner;  ///< closed lines around holes
    std::vector<CircleItem> circles;        ///< dowel holes
    std::vector<Vec2d> outer;               ///< closed line around the piece
    std::vector<std::vector<Vec2d>> engraved, marked;
    std::vector<std::vector<Vec2d>> slit;  ///< by a knife, not through
    bool numbered = false;                 ///< false: no room for its number
};

/// The piece with its cuts grown by half the kerf, its dowel holes, number, the outline of the sheet above,
/// and those of the slits for a liner (of the stack) and of the items' labels that lie on it.
[[nodiscard]] CutPiece cut_piece(const SheetStack& stack, const SheetPiece& piece, const DowelHoles& dowels,
                                 const SheetOptions& options, std::span<const ItemLabel> labels = {},
                                 std::span<const std::vector<Vec2d>> slits = {});

/// What all cuts of a piece come to, mm.
[[nodiscard]] double cut_length(const CutPiece& piece);

}  // namespace snug
