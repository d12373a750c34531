#pragma once

#include <memory>
#include <span>
#include <vector>

#include "snug/depth/object_depths.h"
#include "snug/foam/object_cut.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// A block is cut wherever an item reaches into it, so an item may float above the foam that is left by almost
// a block's height. Lowered by what is free under it in every column it cuts the same blocks below, and lies
// on them.

namespace snug {

/// How far each item may be lowered along x before it would cut more of the foam below itself, mm in steps of
/// 0.1; 0 for what may not be moved. Only columns count where the foam ends where that item cuts it: where
/// a zone or another item takes more away, the item does not lie on it. Items of one group in a layer keep
/// their places to each other. `depths`: what each item sees; `cuts`: what each cuts with its zones.
/// `fixed`: items that stay; one of a group holds all of it.
[[nodiscard]] std::vector<double> free_below_mm(const std::vector<Item>& items,
                                                std::span<const std::shared_ptr<const ObjectDepths>> depths,
                                                std::span<const HalfCuts> cuts, const DesignSpace& space,
                                                const std::vector<bool>& fixed);

}  // namespace snug
