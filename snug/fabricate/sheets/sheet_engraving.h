#pragma once

#include <string>
#include <vector>

#include "snug/base/vec2.h"
#include "snug/fabricate/kit/item_labels.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// What is engraved on a piece, as open lines, mm from the upper left corner of its mask.
struct Engraving {
    std::vector<std::vector<Vec2d>> lines;
    bool numbered = false;  ///< false: no room for the number
};

/// A piece's number with an arrow to BACK where foam stands around them (a sheet's largest piece says BACK as
/// well where there is room), and the odd corner: a line across the corner at BACK and at the low end of z.
/// `holes`: centres and radius of the dowel holes that letters must not meet, mm from the mask's corner.
/// `labels`: of items, that stand on this piece.
[[nodiscard]] Engraving engraving(const SheetStack& stack, const SheetPiece& piece,
                                  const std::vector<Vec2d>& holes, double hole_radius_mm,
                                  const std::vector<ItemLabel>& labels = {});

/// An arrow to BACK of this height; `at`: the middle of its lower end.
[[nodiscard]] std::vector<std::vector<Vec2d>> back_arrow(Half half, Vec2d at, double height_mm);

}  // namespace snug
