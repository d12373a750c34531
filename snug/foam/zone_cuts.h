#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/foam/object_cut.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// What foam gives way to for a zone's sake alone.
struct ZoneCut {
    std::size_t item = 0, zone = 0;  ///< of Packing::items, of its zones
    long long blocks = 0;            ///< beside those that the item cuts and the zones before it
};

/// Adds to what an item cuts what its zones keep foam away from: in each column the blocks that the zone's
/// surface cuts with its own reach, and all between them and the item's. So foam keeps away from a zone all
/// round, and on its way in and out, for foam never stands between an item's cut and where it comes out.
/// `number`: of the item. Fails as object_depths() does.
[[nodiscard]] Result<std::vector<ZoneCut>> cut_zones(const Item& item, std::size_t number,
                                                     const DesignSpace& space, HalfCuts& cuts,
                                                     const Progress& progress = {});

/// 1 in every column that sees a zone of an item with its reach, whatever is asked of the zone: nothing may
/// be put there to carry an item. Fails as object_depths() does.
[[nodiscard]] Result<Grid<char>> zone_columns(const std::vector<Item>& items, const DesignSpace& space);

}  // namespace snug
