#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "snug/search/mask_packer.h"

// The smallest room that holds all pieces: a rectangle by its price, or a strip by its length. Guided by what
// mask_packer.h says of one room: smaller ones are tried over and over, the nearest to success most often.

namespace snug {

/// A layout without clashes.
struct PackedMasks {
    int rows = 0, columns = 0;
    MaskLayout layout;
    long long price = 0;
};

/// Is told every better answer.
using BetterPacking = std::function<void(const PackedMasks&)>;

/// What rooms may be, and for how long to look.
struct RoomTask {
    /// What a room of so many rows and columns costs; more rows or columns never cost less.
    std::function<long long(int rows, int columns)> price;
    int most_rows = 4096, most_columns = 4096;
    std::vector<int> heights{0};  ///< as MaskRoom
    long long known_price = -1;   ///< of an answer that is known already: only better ones count; -1: none
    long long work = 0;           ///< MaskPacker::work() at which it ends
};

/// The best room found; none where no layout better than the known one was found, or no piece ... fits. No
/// piece may be locked, since where the room ends is not known.
[[nodiscard]] std::optional<PackedMasks> smallest_room(MaskPacker& packer, const RoomTask& task,
                                                       const BetterPacking& better = {});

/// The shortest strip of so many columns: its rows are to be few. None where a piece is wider.
[[nodiscard]] std::optional<PackedMasks> shortest_strip(MaskPacker& packer, int columns, long long work,
                                                        const BetterPacking& better = {});

/// Whether a room could hold the pieces, by what they take together and each by itself.
[[nodiscard]] bool may_hold(const MaskProblem& problem, const MaskRoom& room);

/// No room of less price holds the pieces: together they take so many columns, each grown by the gap, and
/// each must go in by itself.
[[nodiscard]] long long least_price(const MaskProblem& problem, const RoomTask& task);

}  // namespace snug
