#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/grid.h"

namespace snug {

/// A true corner of the solid that a height field bounds: a lattice point around which the solid looks the
/// same along no axis.
struct SolidCorner {
    std::uint16_t level = 0;
    /// Two columns meet here in their edge only: the column in front (j = J - 1) has its own vertex, the one
    /// behind (j = J) has the next.
    bool doubled = false;
    std::uint32_t vertex = 0;
};

/// The true corners of a height field, by the upright lattice lines they stand on: line (J, K), with 0 <= J
/// <= ny and 0 <= K <= nz, is the common edge of columns (J - 1, K - 1), (J - 1, K), (J, K - 1) and (J, K).
/// Columns outside the grid have height 0. Vertices are numbered line by line, upwards.
class SolidCorners {
  public:
    explicit SolidCorners(const Grid<std::uint16_t>& heights);

    /// In ascending order of levels; at most five.
    [[nodiscard]] std::span<const SolidCorner> on_line(int J, int K) const;
    [[nodiscard]] std::uint32_t vertex_count() const { return vertex_count_; }

  private:
    void add_line(const std::array<int, 4>& around);

    int lines_per_row_ = 0;
    std::vector<std::uint32_t> first_;  ///< per line, and the end of the last one
    std::vector<SolidCorner> corners_;
    std::uint32_t vertex_count_ = 0;
};

/// Blocks in column (j, k), 0 outside the grid.
[[nodiscard]] inline int height_at(const Grid<std::uint16_t>& heights, int j, int k) {
    return heights.contains(j, k) ? heights(j, k) : 0;
}

}  // namespace snug
