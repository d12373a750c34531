#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace snug {

/// Which columns of the y-z grid something takes: `rows` along y (index j), each `columns` long along z
/// (index k), a bit each.
class BitMask {
  public:
    BitMask() = default;
    BitMask(int rows, int columns)
        : rows_(rows),
          columns_(columns),
          words_((static_cast<std::size_t>(columns) + 63) / 64),
          bits_(static_cast<std::size_t>(rows) * words_) {}

    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] bool operator()(int j, int k) const { return (word(j, k) >> bit(k) & 1) != 0; }
    void set(int j, int k) { bits_[index(j, k)] |= std::uint64_t{1} << bit(k); }

    /// How many columns it takes.
    [[nodiscard]] long long count() const;
    /// Whether it and another, whose first row and column lie at (j, k) of this one's grid, take a common
    /// column. Shifted rows of bits, so exact.
    [[nodiscard]] bool meets(const BitMask& other, int j, int k) const;

    friend bool operator==(const BitMask&, const BitMask&) = default;

  private:
    [[nodiscard]] static int bit(int k) { return k & 63; }
    [[nodiscard]] std::size_t index(int j, int k) const {
        return static_cast<std::size_t>(j) * words_ + static_cast<std::size_t>(k >> 6);
    }
    [[nodiscard]] std::uint64_t word(int j, int k) const { return bits_[index(j, k)]; }
    [[nodiscard]] std::uint64_t bits_from(int j, int k) const;

    int rows_ = 0, columns_ = 0;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> bits_;
};

/// Neighbours of one row that a mask takes: `first` to `end` - 1.
struct MaskRun {
    int row = 0, first = 0, end = 0;
};
/// All of them, row by row.
[[nodiscard]] std::vector<MaskRun> runs_of(const BitMask& mask);

/// Whole columns that stay free between two masks: along y or along z.
struct MaskGap {
    int rows = 0, columns = 0;
    friend bool operator==(MaskGap, MaskGap) = default;
};
/// Grown by a gap towards later rows and columns alone. Two masks keep the gap exactly where those grown like
/// this do not meet, so what they take together bounds how many go into a room.
[[nodiscard]] BitMask grown(const BitMask& mask, MaskGap gap);

}  // namespace snug
