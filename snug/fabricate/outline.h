#pragma once

#include <vector>

#include "snug/fabricate/depth_image.h"

namespace snug {

/// A closed line, its last point joined to its first.
using Loop = std::vector<Vec2d>;

/// A black-and-white image.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<char> cells;  ///< row by row, 1 inside

    Mask(int mask_width, int mask_height)
        : width(mask_width),
          height(mask_height),
          cells(static_cast<std::size_t>(mask_width) * static_cast<std::size_t>(mask_height), 0) {}
    [[nodiscard]] bool inside(int column, int row) const {
        return column >= 0 && row >= 0 && column < width && row < height && cells[index(column, row)] != 0;
    }
    void set(int column, int row) { cells[index(column, row)] = 1; }

  private:
    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// The outlines of a mask in cells (a cell is 1 x 1, the first spans 0 to 1): outer ones clockwise on the
/// page, holes the other way round. Cells that meet in a corner belong together. Stairs are smoothed within
/// half a cell; loops around fewer than `least_cells` cells are left out, unless all are: then the largest
/// stays.
[[nodiscard]] std::vector<Loop> outlines(const Mask& mask, double least_cells);

/// The loop with fewer points, nowhere farther than `tolerance` from it (Douglas and Peucker, 1973).
[[nodiscard]] Loop simplified(const Loop& loop, double tolerance);

/// Positive for loops that run clockwise on the page.
[[nodiscard]] double signed_area(const Loop& loop);

}  // namespace snug
