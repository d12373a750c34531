#pragma once

#include <optional>
#include <vector>

#include "snug/base/vec2.h"
#include "snug/search/mask_packer.h"
#include "snug/search/mask_rooms.h"

// What else packs the same masks, for comparison.

namespace snug::bench {

/// The boxes of the masks in shelves, the deepest first (next fit, decreasing), in every width and either way
/// round: the least price. What makers of trays call automatic.
[[nodiscard]] long long shelf_price(const MaskProblem& problem, const RoomTask& task);

/// libnest2d on the masks' outlines, with its own turns: for every number of rows the fewest columns that it
/// fills, by bisection, and of these the least price. None where it lays them all in none of them.
[[nodiscard]] std::optional<long long> nested_price(const MaskProblem& problem, const RoomTask& task,
                                                    double seconds);
/// libnest2d on polygons themselves: the length of a strip of this height that it needs, to a thousandth of
/// `most`, where it begins. `half_turns`: they may lie upside down.
[[nodiscard]] std::optional<double> nested_strip(const std::vector<std::vector<Vec2d>>& polygons,
                                                 double height, double most, bool half_turns, double seconds);

}  // namespace snug::bench
