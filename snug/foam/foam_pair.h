#pragma once

#include <cstdint>

#include "snug/base/grid.h"
#include "snug/foam/block_map.h"
#include "snug/foam/design_space.h"

namespace snug {

/// The run of blocks that exist in each column: all but those that would stick out of a case with rounded
/// corners or leaning walls. An empty grid stands for all blocks of the space.
using Available = Grid<CutRun>;

/// The blocks of the column that exist.
[[nodiscard]] inline CutRun available_in(const Available& available, std::size_t column, int nx) {
    return available.size() == 0 ? CutRun{0, static_cast<std::int16_t>(nx)} : available[column];
}

/// The two foam halves (section 3.3 of the paper), each a height field: the blocks kept in each column,
/// counted from its own side of the design space (lower from -x, upper from +x). Where the case shortens a
/// column from that side, the height still counts from there and the missing blocks are counted beside it.
struct FoamPair {
    Grid<std::uint16_t> lower;
    Grid<std::uint16_t> upper;
    int parting_level = 0;  ///< lower blocks where the object does not touch the column, 0 to nx
    Grid<std::uint16_t> lower_missing = {};  ///< of `lower`, from its own side; empty grid: none anywhere
    Grid<std::uint16_t> upper_missing = {};
};

[[nodiscard]] FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level,
                             const Available& available = {});

}  // namespace snug
