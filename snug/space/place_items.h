#pragma once

#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/space/item.h"

namespace snug {

/// Where the design's items lie. One without a place of its own lies where the design shifts it to. Where
/// there are several, those without one stand in a row along z, the largest box first, far enough from each
/// other that the foam that is wanted stands between them however they meet the blocks, and centred; each
/// layer in a row of its own, and the layers likewise upon each other. In a
/// space that is fitted to several items all of them are shifted so that their common room is centred; one
/// item keeps its rule. In a tray one surface sinks all items of the uppermost layer (tray.h),
/// and where its height is given they stand on its floor. Walls that differ shift all,
/// see shift_between_walls(). Fails as place() does, and with kind `usage` for an item of an object that
/// there is not.
[[nodiscard]] Result<std::vector<Item>> place_items(std::span<const Object> objects, const Design& design,
                                                    const Progress& progress = {});

}  // namespace snug
