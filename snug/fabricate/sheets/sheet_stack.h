#pragma once

#include <string>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/piece.h"
#include "snug/base/result.h"
#include "snug/base/vec2.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/polygon/cell_loops.h"

// A piece of foam as sheets that are glued on each other. Rows and columns as the piece is seen first, its
// cavity facing the reader: z to the right; y downward but in the lid, where it is upward.

namespace snug {

/// A sheet's thickness as levels of blocks: several sheets in a level, or several levels in a sheet.
struct SheetMeasure {
    double thickness_mm = 0;
    int levels = 1;  ///< that a sheet spans
    int parts = 1;   ///< sheets that a level is made of; 1 unless levels is 1
};

/// Fails (kind usage) with the nearest thicknesses that work where it is no whole part or multiple of the
/// block depth, or where not even one sheet fits into a half.
[[nodiscard]] Result<SheetMeasure> sheet_measure(const FoamDesign& design, double thickness_mm);

/// Foam of one sheet that is connected by the sides of its cells.
struct SheetPiece {
    std::string name;  ///< "L3" for the largest of a sheet, "L3a", "L3b" for its islands
    int sheet = 0;     ///< from the case inwards, 0 first
    bool island = false;
    int column = 0, row = 0;  ///< of the mask's first cell in the half
    Mask mask;                ///< as small as it can be
    int cells = 0;
    std::vector<CellLoop> loops;  ///< in cells of the mask: the first around the piece, the others holes
};

struct SheetStack {
    Piece piece;
    Vec2d cell_mm;
    Grid<int> kept;     ///< sheets up to the cavity in each column: (row, column)
    Grid<int> missing;  ///< of them, those from the case on that it leaves no room for, or a cavity below
    int count = 0;      ///< sheets with foam
    int levels = 1;     ///< of blocks in a sheet
    std::vector<SheetPiece> pieces;
    long long lost_blocks = 0;  ///< foam that the design keeps and sheets of this thickness do not

    [[nodiscard]] int rows() const { return kept.ny(); }
    [[nodiscard]] int columns() const { return kept.nz(); }
    [[nodiscard]] bool has(int row, int column, int sheet) const {
        return kept(row, column) > sheet && missing(row, column) <= sheet;
    }
    [[nodiscard]] Vec2d size_mm() const { return {columns() * cell_mm.x, rows() * cell_mm.y}; }
    /// "L3", "U1", and of pieces between layers "M1-3".
    [[nodiscard]] std::string sheet_name(int sheet) const;
};

/// The pieces of a sheet, the largest first, named after the sheet, with their loops.
[[nodiscard]] std::vector<SheetPiece> sheet_pieces(const SheetStack& stack, int sheet,
                                                   const std::string& sheet_name);

/// Fails (kind usage) where the foam falls into more pieces than anyone glues.
[[nodiscard]] Result<SheetStack> sheet_stack(const FoamDesign& design, Piece piece,
                                             const SheetMeasure& measure);

}  // namespace snug
