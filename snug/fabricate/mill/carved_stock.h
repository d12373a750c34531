#pragma once

#include "snug/base/grid.h"
#include "snug/fabricate/mill/mill_passes.h"

namespace snug {

/// What stands of the stock after the cutter went along its lines, in cells that are finer than the columns:
/// a cell counts as cut to a level where one line's way covers all of it, so that nothing that may still
/// stand goes unseen.
class CarvedStock {
  public:
    /// Cells are no wider than `finest_mm` unless that makes too many of them.
    CarvedStock(const MillField& field, double radius_mm, double finest_mm);

    void cut(const CutLine& line, int level);

    [[nodiscard]] const Grid<int>& height() const { return height_; }  ///< steps, (row, column) of fine cells
    [[nodiscard]] int rows_a_cell() const { return rows_; }
    [[nodiscard]] int columns_a_cell() const { return columns_; }
    [[nodiscard]] Vec2d cell_mm() const { return cell_; }
    [[nodiscard]] Vec2d middle(int row, int column) const {
        return {(column + 0.5) * cell_.x, (row + 0.5) * cell_.y};
    }

  private:
    int rows_ = 1, columns_ = 1;
    double radius_;
    Vec2d cell_;
    Grid<int> height_;
};

}  // namespace snug
