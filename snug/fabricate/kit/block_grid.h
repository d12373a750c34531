#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "snug/base/half.h"
#include "snug/drawing/page_builder.h"

// A half's columns as a grid on a page: its cells, lines, names and edges. Rows and columns as the half is
// seen, its cavity facing the reader.

namespace snug {

struct BlockGrid {
    Half half = Half::lower;
    int rows = 0;
    int columns = 0;
    Vec2d corner;  ///< upper left, mm on the page
    Vec2d cell;    ///< mm on the page

    [[nodiscard]] Vec2d at(int row, int column) const {
        return corner + Vec2d{cell.x * column, cell.y * row};
    }
    [[nodiscard]] Vec2d size() const { return {cell.x * columns, cell.y * rows}; }
    [[nodiscard]] Vec2d middle(int row, int column) const { return at(row, column) + cell * 0.5; }
    /// Counted from BACK, the same in both halves.
    [[nodiscard]] int row_from_back(int row) const { return half == Half::lower ? row : rows - 1 - row; }
};

constexpr double kGridMargin = 12;  ///< mm around a grid for names and BACK

/// Tells whether a cell belongs to what is drawn; false outside the grid.
using CellTest = std::function<bool(int row, int column)>;

/// One rectangle for each run of cells within a row.
void draw_cells(PageBuilder& page, const BlockGrid& grid, const CellTest& inside, Color fill);

/// The borders between cells inside and outside, runs drawn as one line.
void draw_borders(PageBuilder& page, const BlockGrid& grid, const CellTest& inside, const Pen& pen);

/// Thin lines between all blocks.
void draw_grid(PageBuilder& page, const BlockGrid& grid);

/// The foam's outline, the BACK edge thick and named, the corner of column A1 cut off.
void draw_edge(PageBuilder& page, const BlockGrid& grid);

/// Letters of the rows and numbers of the columns on all four sides, as many as can be read.
void draw_names(PageBuilder& page, const BlockGrid& grid);

}  // namespace snug
