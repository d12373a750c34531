#include "snug/foam/foams.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "snug/space/available.h"

namespace snug {
namespace {

/// Above the layer below and below the layer above.
Run between(const BlockMap* below, int below_level, const BlockMap* above, int above_level, Run exists,
            std::size_t column) {
    Run kept = exists;
    if (below) {
        const CutRun cut = (*below)[column];
        kept.first = std::max(kept.first, cut.none() ? static_cast<std::int16_t>(below_level) : cut.end);
    }
    if (above) {
        const CutRun cut = (*above)[column];
        kept.end = std::min(kept.end, cut.none() ? static_cast<std::int16_t>(above_level) : cut.first);
    }
    return kept.none() ? Run{} : kept;
}

}  // namespace

Foams split(std::span<const BlockMap> layers, std::vector<int> parting, const Grid<Run>& available) {
    assert(layers.size() == parting.size());
    Foams foams;
    for (std::size_t piece = 0; piece <= layers.size(); ++piece) {
        const bool lowest = piece == 0, highest = piece == layers.size();
        Grid<Run>& kept = foams.pieces.emplace_back(available.ny(), available.nz());
        for (std::size_t column = 0; column < kept.size(); ++column)
            kept[column] = between(lowest ? nullptr : &layers[piece - 1], lowest ? 0 : parting[piece - 1],
                                   highest ? nullptr : &layers[piece], highest ? 0 : parting[piece],
                                   available[column], column);
    }
    foams.parting = std::move(parting);
    return foams;
}

Foams split(const BlockMap& blocks, int parting_level, const Grid<Run>& available) {
    return split({&blocks, 1}, {parting_level}, available);
}

Foams split(const BlockMap& blocks, const DesignSpace& space, int parting_level) {
    return split(blocks, parting_level, all_blocks(space.blocks));
}

Grid<Run> kept_runs(const Foams& foams, Half half, int nx) {
    Grid<Run> runs = foams.piece(half);
    if (half == Half::lower) return runs;
    for (Run& run : runs)
        if (!run.none()) run = from_other_end(run, nx);
    return runs;
}

}  // namespace snug
