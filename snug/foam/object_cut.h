#pragma once

#include <optional>
#include <span>

#include "snug/base/box.h"
#include "snug/depth/object_depths.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

// Where each half has a clearance of its own, each gives way to the object grown by it: a column's lower foam
// ends below the lowest x that the surface reaches in the cell grown for the lower foam, its upper foam above
// the highest x in the cell grown for the upper. With one clearance for both this is the block map of one
// depth map.
//
// Cells grown differently see different surfaces, so that the lower foam may have to end above the place
// where the upper begins, or only one of them may see the object at all. The two then meet at the parting
// level, as in a column without an object, unless the object stands in the way of one of them: that one ends
// before it, and the other still at the parting level. So in every column
//     the lower foam ends at      first, or where first >= end at the lower of first and the parting level,
//     the upper foam begins at    end,   or where first >= end at the higher of end and the parting level,
// where `first` is the lowest block that the object cuts from the lower foam, `end` the block above the
// highest that it cuts from the upper, and the parting level stands for either that does not exist. Neither
// half ever enters the room of its own, and none of the lower foam lies above any of the upper's, so both
// come out.

namespace snug {

/// What the object cuts from either half alone.
struct HalfCuts {
    BlockMap lower;
    std::optional<BlockMap> upper;  ///< none where it is the same
};
[[nodiscard]] HalfCuts half_cuts(const ObjectDepths& depths, const DesignSpace& space);

/// What several objects of one layer cut together. `items`: one at least, of one space.
[[nodiscard]] HalfCuts united(std::span<const HalfCuts* const> items);

/// What either half cuts: what the parting level is chosen by.
[[nodiscard]] BlockMap cut_by_either(const HalfCuts& cuts);

/// What both cut together, by the rule above.
[[nodiscard]] BlockMap cut_by_both(const HalfCuts& cuts, int parting_level);

/// For searches, which have no parting level yet: the same with the one that would be chosen.
[[nodiscard]] BlockMap object_cut(const HalfCuts& cuts, const DesignSpace& space, const Box3d& placed);

}  // namespace snug
