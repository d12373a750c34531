#include "snug/polygon/corners.h"

#include <algorithm>
#include <utility>

namespace snug {
namespace {

/// What a column is around a level: 0 air, 1 foam that ends there (or, at level 0, air above the ground), 2
/// foam that goes on.
int state(int height, int level) {
    return (height >= level ? 1 : 0) + (height > level ? 1 : 0);
}

/// `around` as in add_line. The level is that of a top, or 0 with foam on it: the solid changes upwards.
bool is_corner(const std::array<int, 4>& around, int level) {
    const int a = state(around[0], level), b = state(around[1], level);
    const int c = state(around[2], level), d = state(around[3], level);
    const bool same_along_j = a == c && b == d;
    const bool same_along_k = a == b && c == d;
    return !same_along_j && !same_along_k;
}

/// Whether the foam around the point is in two parts that share no face. Upper blocks stand on lower ones, so
/// the lowest layer of foam decides.
bool is_doubled(const std::array<int, 4>& around, int level) {
    const int least = std::max(level, 1);
    const bool a = around[0] >= least, b = around[1] >= least;
    const bool c = around[2] >= least, d = around[3] >= least;
    return a == d && b == c && a != b;
}

}  // namespace

SolidCorners::SolidCorners(const Grid<std::uint16_t>& heights) : lines_per_row_(heights.nz() + 1) {
    first_.reserve(static_cast<std::size_t>(heights.ny() + 1) * static_cast<std::size_t>(lines_per_row_) + 1);
    for (int J = 0; J <= heights.ny(); ++J) {
        for (int K = 0; K <= heights.nz(); ++K)
            add_line({height_at(heights, J - 1, K - 1), height_at(heights, J - 1, K),
                      height_at(heights, J, K - 1), height_at(heights, J, K)});
    }
    first_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

/// `around`: the heights of the columns in front to the left and right, behind to the left and right.
void SolidCorners::add_line(const std::array<int, 4>& around) {
    first_.push_back(static_cast<std::uint32_t>(corners_.size()));
    const auto [low, high] = std::minmax_element(around.begin(), around.end());
    if (*low == *high) return;
    std::array<int, 5> levels{0, around[0], around[1], around[2], around[3]};
    std::sort(levels.begin(), levels.end());
    int before = -1;
    for (const int level : levels) {
        if (level != std::exchange(before, level) && is_corner(around, level)) {
            const bool doubled = is_doubled(around, level);
            corners_.push_back({static_cast<std::uint16_t>(level), doubled, vertex_count_});
            vertex_count_ += doubled ? 2 : 1;
        }
    }
}

std::span<const SolidCorner> SolidCorners::on_line(int J, int K) const {
    const std::size_t line =
        static_cast<std::size_t>(J) * static_cast<std::size_t>(lines_per_row_) + static_cast<std::size_t>(K);
    return std::span(corners_).subspan(first_[line], first_[line + 1] - first_[line]);
}

}  // namespace snug
