#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/piece.h"
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

/// Which blocks of one piece are pulled out of a whole block of foam, and which are cut off it because a case
/// that is rounded or leans has no room for them. Of a piece that lies on the case what a layer loses of the
/// blocks that exist in all layers is a part of what the layer above it loses, so that the work goes from the
/// cavity's side downward; one between two layers of items has a cavity on each side.
///
/// The grid lies as the piece is seen, its cavity facing the reader: columns along k to the right; rows along
/// j downward, seen from -x along j upward.
struct PluckPlan {
    Piece piece;
    Half half = Half::lower;      ///< from where it is seen
    int layers = 0;               ///< of the whole block: as many as the piece's highest column keeps
    Grid<std::uint16_t> removed;  ///< blocks to pluck in each column from this side: (row, column) as seen
    Grid<std::uint16_t> behind;   ///< and from the other side; none in a piece that lies on the case
    Grid<Run> exists;             ///< blocks of each column, from the other side, of `layers`
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
        const Run there = exists(row, column);
        const int level = layers - layer;
        return there.contains(level) &&
               (level >= there.end - removed(row, column) || level < there.first + behind(row, column));
    }
    [[nodiscard]] bool cut_off_at(int row, int column, int layer) const {
        return !exists(row, column).contains(layers - layer);
    }
    [[nodiscard]] int deepest() const;
};

[[nodiscard]] PluckPlan pluck_plan(const FoamDesign& design, Piece piece);

/// The same piece between two layers turned over: what is plucked from below, to look at.
[[nodiscard]] PluckPlan seen_from_below(const PluckPlan& plan);

/// "layer 3" or "layers 3 to 5"
[[nodiscard]] Message layers_text(const LayerRun& run);

}  // namespace snug
