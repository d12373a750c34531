#pragma once

#include <optional>
#include <vector>

#include "snug/fabricate/mill/carved_stock.h"

namespace snug {

/// A place beyond the pockets' walls that the cutter goes to, so that it takes foam away that it would leave
/// in an inside corner or a narrow place.
struct MillRelief {
    Vec2d at;
    int level = 0;
    std::optional<Vec2d> from;  ///< on a line of that level; none: straight down from above
};

/// What all of it together does.
struct ReliefReport {
    std::vector<MillRelief> reliefs;
    double widest_mm = 0;    ///< that it goes beyond a wall
    double overcut_mm3 = 0;  ///< of foam that the blocks would keep
    double left_mm3 = 0;     ///< of foam that stays in corners, where the object does not reach
};

/// Makes no cell stand higher than allowed. For each cell that does, the cutter goes where it takes the least
/// foam that was to stay, and `stock` is cut there. `passes` have been cut already.
[[nodiscard]] ReliefReport relieve(const MillField& field, const std::vector<LevelPass>& passes,
                                   const Grid<int>& allowed, double radius_mm, CarvedStock& stock);

}  // namespace snug
