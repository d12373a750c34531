#include "snug/search/mask_clash.h"

#include <algorithm>

namespace snug {
namespace {

constexpr int kStraight = 3, kAslant = 4;  // steps of a distance, Borgefors 1986
constexpr std::uint16_t kFar = 60000;

struct Extent {
    int first_row, last_row, first, last;
};

Extent extent_of(const std::vector<MaskRun>& runs) {
    Extent of{runs.front().row, runs.back().row, runs.front().first, runs.front().end - 1};
    for (const MaskRun& run : runs) {
        of.first = std::min(of.first, run.first);
        of.last = std::max(of.last, run.end - 1);
    }
    return of;
}

}  // namespace

ClashMap::ClashMap(const std::vector<MaskRun>& fixed, const std::vector<MaskRun>& moved, MaskGap gap,
                   int stride)
    : stride_(stride) {
    const Extent a = extent_of(fixed), b = extent_of(moved);
    first_row_ = a.first_row - b.last_row - gap.rows;
    first_column_ = a.first - b.last - gap.columns;
    rows_ = a.last_row - b.first_row + gap.rows - first_row_ + 1;
    columns_ = a.last - b.first + gap.columns - first_column_ + 1;
    plane_rows_ = static_cast<std::size_t>((rows_ + stride - 1) / stride);
    plane_columns_ = static_cast<std::size_t>((columns_ + stride - 1) / stride);
    depth_.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(stride) * plane_rows_ *
                  plane_columns_);
    mark(fixed, moved, gap);
    measure();
}

/// Two runs clash over an interval of shifts: where it begins and ends is noted, and summed up along rows.
void ClashMap::mark(const std::vector<MaskRun>& fixed, const std::vector<MaskRun>& moved, MaskGap gap) {
    std::vector<int> change(static_cast<std::size_t>(columns_) + 1);
    const auto width = change.size();
    change.resize(width * static_cast<std::size_t>(rows_));
    for (const MaskRun& a : fixed)
        for (const MaskRun& b : moved) {
            const int begin = a.first - (b.end - 1) - gap.columns - first_column_;
            const int end = a.end - b.first + gap.columns - first_column_;
            const int row = a.row - b.row - first_row_;
            for (int j = row - gap.rows; j <= row + gap.rows; ++j) {
                int* const line = &change[static_cast<std::size_t>(j) * width];
                ++line[begin];
                --line[end];
            }
        }
    for (int j = 0; j < rows_; ++j) {
        const int* const line = &change[static_cast<std::size_t>(j) * width];
        int over = 0;
        for (int k = 0; k < columns_; ++k) {
            over += line[k];
            depth_[index(j, k)] = over > 0 ? kFar : 0;
        }
    }
}

/// Once down and once up, each place one step from what was measured already.
void ClashMap::measure() {
    const auto at = [&](int j, int k) {
        return j < 0 || j >= rows_ || k < 0 || k >= columns_ ? 0 : int{depth_[index(j, k)]};
    };
    const auto step = [&](int j, int k, int by) {
        std::uint16_t& here = depth_[index(j, k)];
        if (here == 0) return;
        const int least = std::min({at(j - by, k) + kStraight, at(j, k - by) + kStraight,
                                    at(j - by, k - by) + kAslant, at(j - by, k + by) + kAslant});
        here = static_cast<std::uint16_t>(std::min<int>(here, least));
    };
    for (int j = 0; j < rows_; ++j)
        for (int k = 0; k < columns_; ++k) step(j, k, 1);
    for (int j = rows_ - 1; j >= 0; --j)
        for (int k = columns_ - 1; k >= 0; --k) step(j, k, -1);
}

}  // namespace snug
