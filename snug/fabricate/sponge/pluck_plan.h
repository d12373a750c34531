#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// Neighbouring layers that lose the same columns, counted from the cavity's side, the first is 1.
struct LayerRun {
    int first = 1;
    int last = 1;
    long long plucked = 0;  ///< blocks in each of them
    long long cut_off = 0;  ///< in each of them, where the case has no room for a block

    [[nodiscard]] int layers() const { return last - first + 1; }
};

/// Which blocks of one half are pulled out of a whole block of foam, and which are cut off it because a case
/// that is rounded or leans has no room for them. What a layer loses of the blocks that exist in all layers
/// is a part of what the layer above it loses, so that the work goes from the cavity's side downward.
///
/// The grid lies as the half is seen, its cavity facing the reader: columns along k to the right; the rows
/// of the lower half along j downward, those of the lid along j upward.
struct PluckPlan {
    Half half = Half::lower;
    int layers = 0;               ///< of the whole block: as many as the half's highest column keeps
    Grid<std::uint16_t> removed;  ///< blocks to pluck in each column: (row, column) as seen
    Grid<Run> exists;             ///< blocks of each column, from the case's side, of `layers`
    double row_mm = 0;
    double column_mm = 0;
    double layer_mm = 0;
    std::vector<LayerRun> runs;  ///< all layers, from the cavity's side; the last may need no plucking
    long long plucked = 0;
    long long cut_off = 0;

    /// Counted from BACK, the same in both halves.
    [[nodiscard]] int row_from_back(int row) const {
        return half == Half::lower ? row : removed.ny() - 1 - row;
    }
    [[nodiscard]] bool plucked_at(int row, int column, int layer) const {
        const int end = exists(row, column).end, level = layers - layer;
        return level < end && level >= end - removed(row, column);
    }
    [[nodiscard]] bool cut_off_at(int row, int column, int layer) const {
        return !exists(row, column).contains(layers - layer);
    }
    [[nodiscard]] int deepest() const;
};

[[nodiscard]] PluckPlan pluck_plan(const FoamDesign& design, Half half);

/// "layer 3" or "layers 3 to 5"
[[nodiscard]] Message layers_text(const LayerRun& run);

}  // namespace snug
