#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <utility>

#include "snug/base/run.h"
#include "snug/base/vec.h"

#include "tests/support/brute_force.h"

namespace snug::test {

using Columns = std::map<std::pair<int, int>, Run>;  // what is cut of each

[[nodiscard]] inline Columns columns_of(const Blocks& cut, Vec3i n) {
    Columns columns;
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k)
                if (cut.cut(i, j, k)) {
                    Run& run =
                        columns.try_emplace({j, k}, Run{static_cast<std::int16_t>(i), 0}).first->second;
                    run = {std::min(run.first, static_cast<std::int16_t>(i)),
                           std::max(run.end, static_cast<std::int16_t>(i + 1))};
                }
    return columns;
}

/// Of items of different layers the lower one's, `a`, up to the other's along x as well.
[[nodiscard]] inline double distance(const Columns& a, const Columns& b, Vec3d block, bool one_layer) {
    const auto apart = [](int i, int j, double size) { return std::max(0, std::abs(i - j) - 1) * size; };
    double least = 1e9;
    for (const auto& [at, one] : a)
        for (const auto& [place, other] : b) {
            double mm =
                std::max(apart(at.first, place.first, block.y), apart(at.second, place.second, block.z));
            if (!one_layer) mm = std::max(mm, (other.first - one.end) * block.x);
            least = std::min(least, mm);
        }
    return least;
}

}  // namespace snug::test
