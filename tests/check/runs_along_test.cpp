#include "snug/check/runs_along.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

/// Two grids of runs, none of whose blocks are in both.
std::vector<Grid<Run>> random_runs(test::Random& random, Vec3i blocks) {
    std::vector<Grid<Run>> grids(2, Grid<Run>(blocks.y, blocks.z));
    for (std::size_t i = 0; i < grids[0].size(); ++i) {
        const int middle = random.integer(0, blocks.x);
        const int a = random.integer(0, middle), b = random.integer(middle, blocks.x);
        grids[0][i] = {static_cast<std::int16_t>(a), static_cast<std::int16_t>(middle)};
        grids[1][i] = {static_cast<std::int16_t>(middle), static_cast<std::int16_t>(b)};
        if (random.chance(0.3)) grids[1][i] = {};
    }
    return grids;
}

TEST(RunsAlong, AnyAxisCountTheBlocksThatAreThere) {
    for (int i = 0; i < test::cases(200, 10); ++i) {
        SCOPED_TRACE(i);
        test::Random random(static_cast<std::uint64_t>(700 + i));
        const Vec3i blocks{random.integer(1, 9), random.integer(1, 9), random.integer(1, 9)};
        const auto grids = random_runs(random, blocks);
        const auto has = [&](Vec3i at) {
            return grids[0](at.y, at.z).contains(at.x) || grids[1](at.y, at.z).contains(at.x);
        };
        for (int axis = 0; axis < 3; ++axis) {
            RunsAlong runs({&grids[0], &grids[1]}, blocks, axis);
            const int first_axis = axis == 2 ? 1 : 0;  // whose blocks are the lanes
            const int lane_axis = RunsAlong::across(axis, first_axis);
            const int level_axis = RunsAlong::across(axis, 1 - first_axis);
            for (int lane = 0; lane < blocks[lane_axis]; ++lane)
                for (int level = 0; level < blocks[level_axis]; ++level) {
                    if (random.chance(0.3)) continue;  // lines may be passed over
                    runs.go_to(first_axis == 0 ? lane : level, first_axis == 0 ? level : lane);
                    Vec3i at;
                    at[lane_axis] = lane;
                    at[level_axis] = level;
                    int count = 0, first = blocks[axis], end = 0;
                    for (at[axis] = 0; at[axis] < blocks[axis]; ++at[axis]) {
                        ASSERT_EQ(runs.has(at[axis]), has(at));
                        if (!has(at)) continue;
                        ++count;
                        first = std::min(first, at[axis]);
                        end = at[axis] + 1;
                    }
                    EXPECT_EQ(runs.count(0, blocks[axis]), count);
                    EXPECT_EQ(runs.end(), end);
                    if (count > 0) {
                        EXPECT_EQ(runs.first(), first);
                    } else {
                        EXPECT_GE(runs.first(), runs.end());
                    }
                }
        }
    }
}

}  // namespace
}  // namespace snug
