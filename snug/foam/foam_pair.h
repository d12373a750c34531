#pragma once

#include <cstddef>
#include <cstdint>

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/base/run.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// The two foam halves (section 3.3 of the paper), each a height field: how high each column reaches, in
/// blocks counted from its own side of the design space (lower from -x, upper from +x); 0 where it has none.
/// In a case that shortens a column from that side the height still counts from there, but only what exists
/// is kept: kept_run says which blocks those are.
struct FoamPair {
    Grid<std::uint16_t> lower;
    Grid<std::uint16_t> upper;
    int parting_level = 0;  ///< lower blocks where the object does not touch the column, 0 to nx
    Grid<Run> available;    ///< blocks that exist in each column, counted from -x

    [[nodiscard]] const Grid<std::uint16_t>& heights(Half half) const {
        return half == Half::lower ? lower : upper;
    }
};

/// The halves of a block map. No half is higher than the blocks that exist.
[[nodiscard]] FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level,
                             Grid<Run> available);
/// In a plain box, where all blocks exist.
[[nodiscard]] FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level);

/// The blocks that a half keeps in a column of nx blocks, counted from the half's own side: what every table,
/// solid and pack is made from. {0, 0} where it keeps none.
[[nodiscard]] Run kept_run(const FoamPair& foams, Half half, std::size_t column, int nx);
[[nodiscard]] Grid<Run> kept_runs(const FoamPair& foams, Half half, int nx);

/// The blocks that exist in a column of nx blocks, counted from the half's own side.
[[nodiscard]] Run existing_run(const FoamPair& foams, Half half, std::size_t column, int nx);

}  // namespace snug
