#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "snug/design/print_options.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/space/available.h"

#include "tests/support/heights.h"
#include "tests/support/random.h"

namespace snug::test {

/// Steps of terraces with some columns torn out, as cavities are.
[[nodiscard]] inline Heights random_heights(Random& random, Vec3i blocks) {
    Heights heights = filled(blocks.y, blocks.z, random.integer(1, blocks.x));
    for (int i = random.integer(0, 6); i > 0; --i) {
        const int j0 = random.integer(0, blocks.y - 1), j1 = random.integer(j0, blocks.y - 1);
        const int k0 = random.integer(0, blocks.z - 1), k1 = random.integer(k0, blocks.z - 1);
        const auto height = static_cast<std::uint16_t>(random.integer(0, blocks.x));
        for (int j = j0; j <= j1; ++j)
            for (int k = k0; k <= k1; ++k) heights(j, k) = height;
    }
    for (auto& height : heights)
        if (random.chance(0.03)) height = static_cast<std::uint16_t>(random.integer(0, blocks.x));
    return heights;
}

[[nodiscard]] inline BlockMap blocks_between(const Heights& lower, const Heights& upper, int levels) {
    BlockMap blocks(lower.ny(), lower.nz());
    for (std::size_t i = 0; i < blocks.size(); ++i)
        blocks[i] = {static_cast<std::int16_t>(lower[i]), static_cast<std::int16_t>(levels - upper[i])};
    return blocks;
}

/// Both halves, upper ones cut off where they would meet the lower ones.
struct PrintDesign {
    DesignSpace space;
    Foams foams;
    BlockMap blocks;
    Grid<Run> available;

    PrintDesign(DesignSpace in_space, const Heights& lower, Heights upper)
        : space(in_space), available(all_blocks(space.blocks)) {
        for (std::size_t i = 0; i < lower.size(); ++i)
            upper[i] = std::min(upper[i], static_cast<std::uint16_t>(space.blocks.x - lower[i]));
        blocks = blocks_between(lower, upper, space.blocks.x);
        foams = foams_of_heights(lower, upper, space.blocks.x / 2, space.blocks.x);
    }
    /// What a case has no room for goes.
    void shorten(Grid<Run> exists) {
        test::shorten(foams, exists);
        available = std::move(exists);
    }
    [[nodiscard]] FoamDesign view() const { return {space, {&blocks, 1}, foams, available, "L & co"}; }
};

[[nodiscard]] inline PrintDesign random_print_design(Random& random) {
    const DesignSpace space{{random.integer(2, 9), random.integer(1, 14), random.integer(1, 14)},
                            {random.between(2, 12), random.between(2, 12), random.between(2, 12)}};
    Heights lower = random_heights(random, space.blocks), upper = random_heights(random, space.blocks);
    return {space, lower, std::move(upper)};
}

[[nodiscard]] inline PrintOptions random_print_options(Random& random) {
    PrintOptions options;
    options.bed_mm = {random.between(12, 90), random.between(12, 90), random.between(12, 90)};
    options.dowel_diameter_mm = random.between(1, 4);
    options.dowel_length_mm = random.between(options.dowel_diameter_mm, 11);
    options.joint_clearance_mm = random.between(0, 0.4);
    return options;
}

}  // namespace snug::test
