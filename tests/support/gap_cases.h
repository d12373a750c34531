#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "snug/check/gap.h"

namespace snug::test {

inline const Placement kAsItIs{};

inline DesignSpace small_space() {
    return {{6, 6, 6}, {15, 15, 15}};
}

/// Every column within the range loses the same run.
inline BlockMap cut_box(const DesignSpace& space, CutRun run, int j_first, int j_end, int k_first,
                        int k_end) {
    BlockMap blocks(space.blocks.y, space.blocks.z);
    for (int j = j_first; j < j_end; ++j) {
        for (int k = k_first; k < k_end; ++k) blocks(j, k) = run;
    }
    return blocks;
}

/// The cube from -30 to 30 mm.
inline BlockMap cut_cube(const DesignSpace& space) {
    return cut_box(space, {1, 5}, 1, 5, 1, 5);
}

inline GapReport report(const Mesh& mesh, const DesignSpace& space, const BlockMap& blocks,
                        bool closed = true, const Placement& placement = kAsItIs,
                        std::optional<int> level = {}) {
    const auto result =
        gap_report(mesh, placement, space, blocks, level.value_or(space.blocks.x / 2), closed);
    EXPECT_TRUE(result);
    return *result;
}

}  // namespace snug::test
