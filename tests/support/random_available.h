#pragma once

#include <algorithm>
#include <cmath>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"

#include "tests/support/random.h"

namespace snug::test {

/// The blocks that exist in a random case whose walls lean towards its floor and its roof and whose corners
/// are rounded; at least one block does.
[[nodiscard]] inline Grid<Run> random_available(Random& random, Vec3i n) {
    const double line = random.between(0, n.x), lean_below = random.between(0, 1.2),
                 lean_above = random.chance(0.5) ? 0 : random.between(0, 1.2);
    const int corner = random.integer(0, std::min(n.y, n.z) / 2);
    Grid<Run> available(n.y, n.z);
    for (int j = 0; j < n.y; ++j)
        for (int k = 0; k < n.z; ++k) {
            const int in = std::min({j, k, n.y - 1 - j, n.z - 1 - k});
            const bool cut_off = std::min(j, n.y - 1 - j) + std::min(k, n.z - 1 - k) < corner;
            Run run;
            for (int i = 0; i < n.x && !cut_off; ++i) {
                const double lean = std::max((line - i) * lean_below, (i + 1 - line) * lean_above);
                if (lean > in + 1) continue;
                if (run.none()) run.first = static_cast<std::int16_t>(i);
                run.end = static_cast<std::int16_t>(i + 1);
            }
            available(j, k) = run;
        }
    available(n.y / 2, n.z / 2) = {0, static_cast<std::int16_t>(n.x)};
    return available;
}

}  // namespace snug::test
