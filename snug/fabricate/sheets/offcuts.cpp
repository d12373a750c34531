#include "snug/fabricate/sheets/offcuts.h"

#include <algorithm>
#include <cstddef>

namespace snug {
namespace {

/// Bit i of the result is bit i + by.
void shift_down(BitRow& row, int by) {
    const std::size_t words = static_cast<std::size_t>(by) / 64;
    const int bits = by % 64;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::uint64_t low = i + words < row.size() ? row[i + words] : 0;
        const std::uint64_t high = i + words + 1 < row.size() ? row[i + words + 1] : 0;
        row[i] = bits == 0 ? low : (low >> bits) | (high << (64 - bits));
    }
}

void keep_common(BitRow& row, const BitRow& other) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] &= other[i];
}

bool empty(const BitRow& row) {
    return std::all_of(row.begin(), row.end(), [](std::uint64_t word) { return word == 0; });
}

/// Bits from which on `length` bits are set.
BitRow run_starts(BitRow row, int length) {
    for (int reached = 1; reached < length;) {
        const int step = std::min(reached, length - reached);
        BitRow shifted = row;
        shift_down(shifted, step);
        keep_common(row, shifted);
        reached += step;
    }
    return row;
}

struct CellRun {
    int row, first, length;
};

std::vector<CellRun> cell_runs_of(const Mask& mask) {
    std::vector<CellRun> runs;
    for (int row = 0; row < mask.height; ++row)
        for (int column = 0; column < mask.width; ++column) {
            if (!mask.contains(column, row)) continue;
            if (!mask.contains(column - 1, row)) runs.push_back({row, column, 0});
            ++runs.back().length;
        }
    // Long runs rule out most places.
    std::stable_sort(runs.begin(), runs.end(),
                     [](const CellRun& a, const CellRun& b) { return a.length > b.length; });
    return runs;
}

int first_bit(const BitRow& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
        for (int bit = 0; row[i] != 0 && bit < 64; ++bit)
            if ((row[i] >> bit & 1) != 0) return static_cast<int>(i) * 64 + bit;
    return -1;
}

}  // namespace

Offcuts::Offcuts(const Mask& piece, int gap_columns, int gap_rows)
    : width_(piece.width), height_(piece.height), gap_columns_(gap_columns), gap_rows_(gap_rows) {
    BitRow full(static_cast<std::size_t>(width_ + 63) / 64, 0);
    for (int column = 0; column < width_; ++column)
        full[static_cast<std::size_t>(column) / 64] |= std::uint64_t{1} << (column % 64);
    free_.assign(static_cast<std::size_t>(height_), full);
    free_cells_ = static_cast<long long>(width_) * height_;
    take(piece, {0, 0});
}

std::optional<CellPoint> Offcuts::room_for(const Mask& piece, int cells, long long& work) const {
    if (piece.width > width_ || piece.height > height_ || cells > free_cells_) return {};
    const std::vector<CellRun> runs = cell_runs_of(piece);
    for (int y = 0; y + piece.height <= height_; ++y) {
        BitRow places;
        for (const CellRun& run : runs) {
            BitRow starts = run_starts(free_[static_cast<std::size_t>(y + run.row)], run.length);
            shift_down(starts, run.first);
            if (places.empty())
                places = std::move(starts);
            else
                keep_common(places, starts);
            work += static_cast<long long>(places.size()) * 4;
            if (empty(places)) break;
        }
        const int x = first_bit(places);
        if (x >= 0) return CellPoint{x, y};
    }
    return {};
}

void Offcuts::take(const Mask& piece, CellPoint at) {
    for (const CellRun& run : cell_runs_of(piece)) {
        const int first = std::max(at.x + run.first - gap_columns_, 0);
        const int end = std::min(at.x + run.first + run.length + gap_columns_, width_);
        const int last_row = std::min(at.y + run.row + gap_rows_, height_ - 1);
        for (int row = std::max(at.y + run.row - gap_rows_, 0); row <= last_row; ++row) {
            BitRow& bits = free_[static_cast<std::size_t>(row)];
            for (int column = first; column < end; ++column) {
                std::uint64_t& word = bits[static_cast<std::size_t>(column) / 64];
                const std::uint64_t bit = std::uint64_t{1} << (column % 64);
                if ((word & bit) != 0) --free_cells_;
                word &= ~bit;
            }
        }
    }
}

}  // namespace snug
