#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "snug/polygon/cell_loops.h"

namespace snug {

/// A row of cells, 64 to a word.
using BitRow = std::vector<std::uint64_t>;

/// The cells within a piece's bounding box that are still free, where smaller pieces may lie.
class Offcuts {
  public:
    /// Free is what lies more than `gap_columns` and `gap_rows` from the piece.
    Offcuts(const Mask& piece, int gap_columns, int gap_rows);

    /// The first place (row by row) where all of a piece's cells are free; counts the words it looked at.
    [[nodiscard]] std::optional<CellPoint> room_for(const Mask& piece, int cells, long long& work) const;

    /// Takes the piece's cells and the gap around them.
    void take(const Mask& piece, CellPoint at);

  private:
    int width_, height_, gap_columns_, gap_rows_;
    long long free_cells_ = 0;
    std::vector<BitRow> free_;
};

}  // namespace snug
