#pragma once

#include <cstdint>
#include <utility>

#include "tests/support/cut_foams.h"

namespace snug::test {

/// Hills, pits, lone columns and untouched ground.
[[nodiscard]] inline CutFoams random_sheet_foam(Random& random, bool in_a_case = false) {
    const Vec3i blocks{random.integer(1, 9), random.integer(1, 14), random.integer(1, 14)};
    const Vec3d size{random.between(5, 30), random.between(5, 30), random.between(5, 30)};
    BlockMap map(blocks.y, blocks.z);
    const double busy = random.unit();
    for (CutRun& run : map) {
        if (!random.chance(busy)) continue;
        const int first = random.integer(0, blocks.x - 1);
        run = {static_cast<std::int16_t>(first), static_cast<std::int16_t>(random.integer(first, blocks.x))};
    }
    const int parting = random.integer(0, blocks.x);
    return foams_of({blocks, size}, std::move(map), parting,
                    in_a_case ? random_available(random, blocks) : all_blocks(blocks));
}

/// An L seen from +x: its long stroke along z at low y, the short one downward at low z; deeper at its foot.
[[nodiscard]] inline CutFoams l_shaped_foam() {
    BlockMap map(7, 9);
    for (int k = 2; k < 7; ++k) map(1, k) = {2, 5};
    for (int j = 2; j < 5; ++j) map(j, 2) = {1, 4};
    return foams_of({{6, 7, 9}, {15, 20, 25}}, std::move(map), 3);
}

}  // namespace snug::test
