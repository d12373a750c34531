#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/polygon/row_triangulator.h"
#include "snug/solid/corner_fans.h"

namespace snug {

/// A true corner of a solid of blocks: a lattice point around which the solid looks the same along no axis.
struct SolidCorner {
    int level = 0;
    std::uint32_t vertex = 0;  ///< of its first fan; the others' follow
    const CornerFans* fans = nullptr;

    /// At a face as octant_face numbers them; kNoVertex where there is none.
    [[nodiscard]] std::uint32_t vertex_at(int face) const {
        const std::uint8_t fan = fans->fan[static_cast<std::size_t>(face)];
        return fan == kNoFan ? kNoVertex : vertex + fan;
    }
};

/// The true corners of the solid that has one run of blocks in each column, by the upright lattice lines they
/// stand on: line (J, K), with 0 <= J <= ny and 0 <= K <= nz, is the common edge of columns (J - 1, K - 1),
/// (J - 1, K), (J, K - 1) and (J, K). Columns outside the grid have no blocks. Vertices are numbered line by
/// line, upwards.
class SolidCorners {
  public:
    explicit SolidCorners(const Grid<Run>& runs);

    /// In ascending order of levels; at most eight.
    [[nodiscard]] std::span<const SolidCorner> on_line(int J, int K) const;
    /// Level, J and K of each vertex.
    [[nodiscard]] const std::vector<Vec3i>& points() const { return points_; }

  private:
    int lines_per_row_ = 0;
    std::vector<std::uint32_t> first_;  ///< per line, and the end of the last one
    std::vector<SolidCorner> corners_;
    std::vector<Vec3i> points_;
};

/// The blocks of column (j, k), none outside the grid.
[[nodiscard]] inline Run run_at(const Grid<Run>& runs, int j, int k) {
    return runs.contains(j, k) ? runs(j, k) : Run{};
}

}  // namespace snug
