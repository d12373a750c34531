#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "snug/search/mask.h"

namespace snug {

/// How deep one mask lies in another, for every way to lay them side by side: the no-fit raster of the two,
/// and for each of its places the distance to the nearest one outside it (as in Sato and others, Raster
/// penetration map applied to the irregular packing problem, 2019). Exact as to whether they clash; the
/// distance is by steps of 3 along an axis and 4 aslant.
class ClashMap {
  public:
    /// They clash where they take common columns, or fewer than the gap lie between them both ways. `stride`:
    /// of the places that are looked at together, see places().
    ClashMap(const std::vector<MaskRun>& fixed, const std::vector<MaskRun>& moved, MaskGap gap,
             int stride = 1);

    /// Where the moved mask's first row and column lie `rows` and `columns` after the fixed one's; 0: they do
    /// not clash.
    [[nodiscard]] int depth(int rows, int columns) const {
        const int j = rows - first_row_, k = columns - first_column_;
        if (j < 0 || j >= rows_ || k < 0 || k >= columns_) return 0;
        return depth_[index(j, k)];
    }

    // For whoever looks at many places at once: the raster begins at this one, and outside it all is free.
    [[nodiscard]] int first_row() const { return first_row_; }
    [[nodiscard]] int first_column() const { return first_column_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int columns() const { return columns_; }
    /// The place (j, k) of the raster and those after it in its row, one stride from each other.
    [[nodiscard]] const std::uint16_t* places(int j, int k) const { return &depth_[index(j, k)]; }

  private:
    /// Places that are a stride apart lie beside each other: a plane for each that comes first.
    [[nodiscard]] std::size_t index(int j, int k) const {
        const int plane = j % stride_ * stride_ + k % stride_;
        return (static_cast<std::size_t>(plane) * plane_rows_ + static_cast<std::size_t>(j / stride_)) *
                   plane_columns_ +
               static_cast<std::size_t>(k / stride_);
    }
    void mark(const std::vector<MaskRun>& fixed, const std::vector<MaskRun>& moved, MaskGap gap);
    void measure();

    int stride_ = 1;
    std::size_t plane_rows_ = 0, plane_columns_ = 0;
    int first_row_ = 0, first_column_ = 0, rows_ = 0, columns_ = 0;
    std::vector<std::uint16_t> depth_;
};

}  // namespace snug
