#pragma once

#include "tests/support/print_design.h"

namespace snug::test {

/// Random height fields in blocks that bricks have.
[[nodiscard]] inline PrintDesign random_brick_design(Random& random) {
    const double heights[] = {9.6, 3.2, 19.2, 6.4};
    const DesignSpace space{
        {random.integer(2, 9), random.integer(1, 16), random.integer(1, 16)},
        {heights[random.integer(0, 3)], 8.0 * random.integer(1, 2), 8.0 * random.integer(1, 3)}};
    Heights lower = random_heights(random, space.blocks), upper = random_heights(random, space.blocks);
    return {space, lower, std::move(upper)};
}

/// Lets the outer blocks of some rim columns be missing, as a case with rounded corners does.
inline void round_corners(Random& random, PrintDesign& design) {
    const int nx = design.space.blocks.x, ny = design.space.blocks.y, nz = design.space.blocks.z;
    const Heights lower = lower_heights(design.foams), upper = upper_heights(design.foams, nx);
    Grid<Run> available = design.available;
    for (int j = 0; j < ny; ++j)
        for (int k = 0; k < nz; ++k) {
            const bool corner = (j == 0 || j == ny - 1) && (k == 0 || k == nz - 1);
            if (!corner || !random.chance(0.7)) continue;
            Run& exists = available(j, k);
            if (lower(j, k) > 1) exists.first = 1;
            if (upper(j, k) > 1) exists.end = static_cast<std::int16_t>(nx - 1);
        }
    design.shorten(std::move(available));
}

}  // namespace snug::test
