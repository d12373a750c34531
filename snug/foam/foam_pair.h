#pragma once

#include <cstdint>

#include "snug/base/grid.h"
#include "snug/foam/block_map.h"
#include "snug/foam/design_space.h"

namespace snug {

/// The two foam halves (section 3.3 of the paper), each a height field: the blocks kept in each column,
/// counted from its own side of the design space (lower from -x, upper from +x).
struct FoamPair {
    Grid<std::uint16_t> lower;
    Grid<std::uint16_t> upper;
    int parting_level = 0;  ///< lower blocks where the object does not touch the column, 0 to nx
};

[[nodiscard]] FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level);

}  // namespace snug
