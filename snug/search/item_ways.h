#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/result.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/mask.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// One way to lay an item on blocks, wherever they are: a rotation, and how it and its zones meet them.
struct ItemWay {
    Vec3d rotation_deg;
    /// From the corner of the first level, row and column that it cuts to the item's offset. mm.
    Vec3d offset_mm;
    BitMask mask;   ///< the columns that it reaches, from its first row and column
    Grid<Run> cut;  ///< in each of them, from its first level; squeezed, it may cut nothing there
    bool halves_differ = false;  ///< they keep away differently, and meet where they part
    int height = 0;              ///< blocks from the lowest level that it cuts to the highest
    long long cut_blocks = 0;
};

/// Rotations that an item may have: as it is given, and what the design's turns allow besides
/// (SearchOptions::turns, and ::upright where that is chosen). The given one first, unless the upright axis
/// forbids it.
[[nodiscard]] std::vector<Vec3d> allowed_rotations(const Object& object, Vec3d given_deg,
                                                   const SearchOptions& options);

/// For each rotation, of so many `places` within a block along y and along z, those that cut the fewest
/// columns, of these the fewest blocks, and what is narrower along one axis, however many it cuts: a few.
/// Exact, with the clearance, from the depth maps. Never more than `most`. `object`: prepared for many
/// (prepare.h); `zones`: as searched_zones() has them. Empty where it cuts nothing in any way. Fails as
/// place() does.
[[nodiscard]] Result<std::vector<ItemWay>> ways_to_lay(const Object& object, const CutOptions& cut,
                                                       Vec3d block_mm,
                                                       const std::vector<Vec3d>& rotations_deg, int places,
                                                       std::size_t most, const std::vector<ItemZone>& zones);

/// The only way of an item that stays where it is, and where its first level, row and column lie in the
/// space.
struct LockedWay {
    ItemWay way;
    Vec3i first;
};
[[nodiscard]] Result<LockedWay> locked_way(const Object& object, const CutOptions& cut,
                                           const DesignSpace& space, Vec3d rotation_deg, Vec3d offset_mm,
                                           const std::vector<ItemZone>& zones);

}  // namespace snug
