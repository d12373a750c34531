#include "snug/foam/foam_pair.h"

namespace snug {

FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level) {
    FoamPair foams{{blocks.ny(), blocks.nz()}, {blocks.ny(), blocks.nz()}, parting_level};
    for (std::size_t column = 0; column < blocks.size(); ++column) {
        const CutRun run = blocks[column];
        const int below = run.none() ? parting_level : run.first;
        const int above = space.blocks.x - (run.none() ? parting_level : run.end);
        foams.lower[column] = static_cast<std::uint16_t>(below);
        foams.upper[column] = static_cast<std::uint16_t>(above);
    }
    return foams;
}

}  // namespace snug
