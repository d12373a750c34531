#include "snug/search/mask.h"

#include <algorithm>
#include <bit>

namespace snug {

long long BitMask::count() const {
    long long sum = 0;
    for (const std::uint64_t word : bits_) sum += std::popcount(word);
    return sum;
}

/// 64 columns of a row that begin anywhere, also before it; what lies outside is not taken.
std::uint64_t BitMask::bits_from(int j, int k) const {
    if (k <= -64 || k >= columns_) return 0;
    if (k < 0) return word(j, 0) << -k;
    std::uint64_t bits = word(j, k) >> bit(k);
    if (bit(k) != 0 && (k | 63) + 1 < columns_) bits |= word(j, (k | 63) + 1) << (64 - bit(k));
    return bits;
}

bool BitMask::meets(const BitMask& other, int j, int k) const {
    const int first = std::max(0, j), end = std::min(rows_, j + other.rows_);
    for (int row = first; row < end; ++row)
        for (int column = 0; column < other.columns_; column += 64)
            if ((other.word(row - j, column) & bits_from(row, k + column)) != 0) return true;
    return false;
}

std::vector<MaskRun> runs_of(const BitMask& mask) {
    std::vector<MaskRun> runs;
    for (int j = 0; j < mask.rows(); ++j)
        for (int k = 0; k < mask.columns(); ++k) {
            if (!mask(j, k)) continue;
            const int first = k;
            while (k < mask.columns() && mask(j, k)) ++k;
            runs.push_back({j, first, k});
        }
    return runs;
}

BitMask grown(const BitMask& mask, MaskGap gap) {
    BitMask result(mask.rows() + gap.rows, mask.columns() + gap.columns);
    for (const MaskRun& run : runs_of(mask))
        for (int j = run.row; j <= run.row + gap.rows; ++j)
            for (int k = run.first; k < run.end + gap.columns; ++k) result.set(j, k);
    return result;
}

}  // namespace snug
