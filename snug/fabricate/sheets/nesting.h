#pragma once

#include <span>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec2.h"
#include "snug/design/sheet_options.h"
#include "snug/polygon/cell_loops.h"

// Pieces that are unions of equal cells, laid out on sheets of stock. Pieces keep their way up.

namespace snug {

struct PieceToNest {
    std::string name;  ///< for messages
    const Mask* mask = nullptr;
    int cells = 0;
    int color = 0;  ///< of the foam that it is cut from, 0 or 1
};

struct PiecePlace {
    int stock = 0;
    Vec2d corner;   ///< of the mask, upper left, mm from the stock's upper left corner
    int host = -1;  ///< the piece within whose bounding box this one lies; none: -1
};

struct Nesting {
    Vec2d stock_mm;  ///< as it lies: the options' way round or turned by 90 degrees
    int stocks = 0;
    std::vector<PiecePlace> places;  ///< one for each piece
    double used_mm2 = 0;             ///< of stock, up to the lowest piece on each
    int first_color_stocks = 0;      ///< those after them are of the second colour
};

/// Small pieces go into the offcuts of larger ones, cell by cell, and the others beside each other by
/// bounding boxes (skyline, bottom left), first fit; then all of them closer where that takes less stock
/// (close_nesting.h). Cuts of different pieces stay the spacing apart. Without `in_offcuts` by bounding boxes
/// only. Those of the second colour come on sheets of their own, after the others. Fails (kind usage) with
/// the stock that would do where a piece is too large.
[[nodiscard]] Result<Nesting> nest(std::span<const PieceToNest> pieces, Vec2d cell_mm,
                                   const SheetOptions& options, bool in_offcuts = true);

}  // namespace snug
