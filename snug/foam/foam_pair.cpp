#include "snug/foam/foam_pair.h"

#include <algorithm>

namespace snug {
namespace {

/// Takes away what does not exist of one half: `missing` blocks from its own side, and all above `highest`.
void shorten(std::uint16_t& height, std::uint16_t& missing, int absent, int highest) {
    const int top = std::min<int>(height, highest);
    height = static_cast<std::uint16_t>(top > absent ? top : 0);
    missing = static_cast<std::uint16_t>(height > 0 ? absent : 0);
}

}  // namespace

FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level,
               const Available& available) {
    FoamPair foams{{blocks.ny(), blocks.nz()}, {blocks.ny(), blocks.nz()}, parting_level};
    for (std::size_t column = 0; column < blocks.size(); ++column) {
        const CutRun run = blocks[column];
        const int below = run.none() ? parting_level : run.first;
        const int above = space.blocks.x - (run.none() ? parting_level : run.end);
        foams.lower[column] = static_cast<std::uint16_t>(below);
        foams.upper[column] = static_cast<std::uint16_t>(above);
    }
    if (available.size() == 0) return foams;
    foams.lower_missing = {blocks.ny(), blocks.nz()};
    foams.upper_missing = {blocks.ny(), blocks.nz()};
    const int nx = space.blocks.x;
    for (std::size_t column = 0; column < blocks.size(); ++column) {
        const CutRun run = available[column];
        shorten(foams.lower[column], foams.lower_missing[column], run.first, run.none() ? 0 : run.end);
        shorten(foams.upper[column], foams.upper_missing[column], nx - run.end,
                run.none() ? 0 : nx - run.first);
    }
    return foams;
}

}  // namespace snug
