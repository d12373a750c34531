#pragma once

#include "snug/base/half.h"

namespace snug {

/// One piece of the foams, counted from below: L layers lie between L + 1. All but the uppermost lie as the
/// lower half does, so that what lies on them is laid in from above. A tray leaves the uppermost out, and
/// counts it all the same.
struct Piece {
    int index = 0;
    int count = 2;

    constexpr Piece() = default;
    constexpr Piece(int index_, int count_) : index(index_), count(count_) {}
    /// Of the two pieces of one layer.
    constexpr Piece(Half half) : index(half == Half::lower ? 0 : 1) {}

    [[nodiscard]] constexpr bool highest() const { return index == count - 1; }
    /// Whether it lies between two layers, and so is worked from both sides; `index` is its number then.
    [[nodiscard]] constexpr bool middle() const { return index > 0 && !highest(); }
    /// From where it is looked at and worked first.
    [[nodiscard]] constexpr Half half() const { return highest() ? Half::lid : Half::lower; }
    friend constexpr bool operator==(const Piece&, const Piece&) = default;
};

}  // namespace snug
