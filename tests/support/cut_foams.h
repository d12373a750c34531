#pragma once

#include <cstdint>
#include <utility>

#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/foam/foams.h"
#include "snug/space/available.h"

#include "tests/support/random.h"
#include "tests/support/random_available.h"

namespace snug::test {

/// A packing without an object: runs of blocks that someone cut.
struct CutFoams {
    DesignSpace space;
    BlockMap blocks;
    Foams foams;
    Grid<Run> available;

    [[nodiscard]] FoamDesign design() const { return {space, {&blocks, 1}, foams, available, "a test"}; }
    [[nodiscard]] long long cut() const {
        long long count = 0;
        for (const CutRun& run : blocks) count += run.blocks();
        return count;
    }
};

[[nodiscard]] inline CutFoams foams_of(const DesignSpace& space, BlockMap blocks, int parting,
                                       Grid<Run> available) {
    Foams foams = split(blocks, parting, available);
    return {space, std::move(blocks), std::move(foams), std::move(available)};
}
[[nodiscard]] inline CutFoams foams_of(const DesignSpace& space, BlockMap blocks, int parting) {
    return foams_of(space, std::move(blocks), parting, all_blocks(space.blocks));
}

/// Runs that are cut at random, inside a box or a case.
[[nodiscard]] inline CutFoams random_foams(Random& random, bool in_a_case = false) {
    const DesignSpace space{{random.integer(1, 12), random.integer(1, 30), random.integer(1, 30)},
                            {random.between(1, 30), random.between(1, 30), random.between(1, 30)}};
    BlockMap blocks(space.blocks.y, space.blocks.z);
    for (CutRun& run : blocks) {
        if (random.chance(0.4)) continue;
        run.first = static_cast<std::int16_t>(random.integer(0, space.blocks.x));
        run.end = static_cast<std::int16_t>(random.integer(0, space.blocks.x));
    }
    const int parting = random.integer(0, space.blocks.x);
    return foams_of(space, std::move(blocks), parting,
                    in_a_case ? random_available(random, space.blocks) : all_blocks(space.blocks));
}

}  // namespace snug::test
