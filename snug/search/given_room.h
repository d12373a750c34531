#pragma once

#include <optional>
#include <vector>

#include "snug/base/result.h"
#include "snug/search/arranged_items.h"
#include "snug/space/space_for.h"

namespace snug {

/// The room inside the walls of a space that is given, as masks are packed into it.
struct GivenRoom {
    DesignSpace space;
    BlockWalls walls;
    std::vector<LayerLevels> levels;
    MaskRoom room;
};

/// `heights`: of its layers, the lowest first. Where blocks are missing at the case's walls no item may lie
/// so that it, or its walls, would need them. In a tray how high items are does not count.
[[nodiscard]] GivenRoom given_room(const PackedSpace& given, const ItemMasks& masks, const Design& design,
                                   const std::vector<int>& heights);

}  // namespace snug
