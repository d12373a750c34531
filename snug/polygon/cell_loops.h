#pragma once

#include <cstddef>
#include <vector>

namespace snug {

/// A black-and-white image.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<char> cells;  ///< row by row, 1 inside

    Mask() = default;
    Mask(int mask_width, int mask_height)
        : width(mask_width),
          height(mask_height),
          cells(static_cast<std::size_t>(mask_width) * static_cast<std::size_t>(mask_height), 0) {}
    [[nodiscard]] bool contains(int column, int row) const {
        return column >= 0 && row >= 0 && column < width && row < height && cells[index(column, row)] != 0;
    }
    void set(int column, int row) { cells[index(column, row)] = 1; }

  private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// Where cells meet; cell (column, row) spans column to column + 1 and row to row + 1.
struct CellPoint {
    int x = 0, y = 0;
    friend bool operator==(CellPoint, CellPoint) = default;
};

/// A closed line along the sides of cells: its corners only.
using CellLoop = std::vector<CellPoint>;

/// The exact outlines of a mask: outer ones clockwise on the page (the inside on the right-hand side of who
/// walks along), holes the other way round. Cells that meet in a corner belong together, so a loop around
/// cells that are connected by their sides never meets itself, though two loops may meet in points.
[[nodiscard]] std::vector<CellLoop> cell_loops(const Mask& mask);

}  // namespace snug
