#pragma once

#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/base/run.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// The pieces of foam (section 3.3 of the paper, for any number of layers), lowest first: L layers of items
/// lie between L + 1 pieces.
struct Foams {
    /// The blocks that a piece keeps in each column, counted from -x; {0, 0} where it keeps none. So a piece
    /// is a height field from each of its sides.
    std::vector<Grid<Run>> pieces;
    /// For each layer the level where the pieces below and above it meet in columns that no item of it
    /// touches, 0 to nx blocks.
    std::vector<int> parting;

    [[nodiscard]] const Grid<Run>& piece(Half half) const {
        return half == Half::lower ? pieces.front() : pieces.back();
    }
};

/// The pieces around the blocks that each layer cuts, lowest first. No piece has blocks that do not exist
/// (`available`).
[[nodiscard]] Foams split(std::span<const BlockMap> layers, std::vector<int> parting,
                          const Grid<Run>& available);

/// The two foams of one layer.
[[nodiscard]] Foams split(const BlockMap& blocks, int parting_level, const Grid<Run>& available);
/// In a plain box, where all blocks exist.
[[nodiscard]] Foams split(const BlockMap& blocks, const DesignSpace& space, int parting_level);

/// The blocks that a half keeps in each column of nx blocks, counted from the half's own side (the lower
/// foam's from -x, the lid's from +x): `end` is how high it reaches.
[[nodiscard]] Grid<Run> kept_runs(const Foams& foams, Half half, int nx);

}  // namespace snug
