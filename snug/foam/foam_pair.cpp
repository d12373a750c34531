#include "snug/foam/foam_pair.h"

#include <algorithm>
#include <utility>

#include "snug/space/available.h"

namespace snug {
namespace {

/// Of a column that reaches to `height` in blocks that exist; counted from one side.
std::uint16_t height_within(Run exists, int height) {
    const int top = std::min<int>(height, exists.end);
    return static_cast<std::uint16_t>(top > exists.first ? top : 0);
}

}  // namespace

FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level, Grid<Run> available) {
    const int nx = space.blocks.x;
    FoamPair foams{
        {blocks.ny(), blocks.nz()}, {blocks.ny(), blocks.nz()}, parting_level, std::move(available)};
    for (std::size_t column = 0; column < blocks.size(); ++column) {
        const Run cut = blocks[column], exists = foams.available[column];
        const int below = cut.none() ? parting_level : cut.first;
        const int above = nx - (cut.none() ? parting_level : cut.end);
        foams.lower[column] = height_within(exists, below);
        foams.upper[column] = height_within(from_other_end(exists, nx), above);
    }
    return foams;
}

FoamPair split(const BlockMap& blocks, const DesignSpace& space, int parting_level) {
    return split(blocks, space, parting_level, all_blocks(space.blocks));
}

Run existing_run(const FoamPair& foams, Half half, std::size_t column, int nx) {
    const Run exists = foams.available[column];
    return half == Half::lower ? exists : from_other_end(exists, nx);
}

Run kept_run(const FoamPair& foams, Half half, std::size_t column, int nx) {
    const std::uint16_t height = foams.heights(half)[column];
    if (height == 0) return {};
    return {existing_run(foams, half, column, nx).first, static_cast<std::int16_t>(height)};
}

Grid<Run> kept_runs(const FoamPair& foams, Half half, int nx) {
    Grid<Run> runs(foams.lower.ny(), foams.lower.nz());
    for (std::size_t column = 0; column < runs.size(); ++column)
        runs[column] = kept_run(foams, half, column, nx);
    return runs;
}

}  // namespace snug
