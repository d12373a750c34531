#include "snug/fabricate/kit/fit_test.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/cut_foams.h"

namespace snug {
namespace {

using test::CutFoams;
using test::foams_of;
using test::Random;
using test::random_foams;

TEST(FitTestTest, TheRingIsTheFoamAroundTheOpening) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const CutFoams foams = random_foams(random);
        const double wide = random.between(1, 60);
        const auto test = fit_test(foams.design(), wide);
        const int level = foams.foams.parting.front();
        const auto cut = [&](int j, int k, int layer) {
            const CutRun run = foams.blocks(j, k);
            return run.first <= layer && layer < run.end;
        };
        long long below = 0, above = 0;
        for (int j = 0; j < foams.space.blocks.y; ++j)
            for (int k = 0; k < foams.space.blocks.z; ++k) {
                below += cut(j, k, level - 1);
                above += cut(j, k, level);
            }
        ASSERT_EQ(test.has_value(), below + above > 0);
        if (!test) continue;
        EXPECT_EQ(test->level, above > below ? level : level - 1);
        const int reach_y = std::max(1, static_cast<int>(std::ceil(wide / foams.space.block_mm.y)));
        const int reach_z = std::max(1, static_cast<int>(std::ceil(wide / foams.space.block_mm.z)));
        for (int j = 0; j < foams.space.blocks.y; ++j)
            for (int k = 0; k < foams.space.blocks.z; ++k) {
                EXPECT_TRUE(test->opening(j, k) || !cut(j, k, test->level));
                bool near = false;
                for (int j2 = j - reach_y; j2 <= j + reach_y; ++j2)
                    for (int k2 = k - reach_z; k2 <= k + reach_z; ++k2)
                        near |= test->opening.contains(j2, k2) && test->opening(j2, k2);
                EXPECT_EQ(test->ring(j, k) != 0, near && !test->opening(j, k));
            }
    }
}

TEST(FitTestTest, IslandsAreLeftOut) {
    const DesignSpace space{{4, 7, 7}, {10, 10, 10}};
    BlockMap blocks(7, 7);
    for (int j = 2; j <= 4; ++j)
        for (int k = 2; k <= 4; ++k)
            if (j != 3 || k != 3) blocks(j, k) = {1, 3};
    const CutFoams foams = foams_of(space, std::move(blocks), 2);
    const auto test = fit_test(foams.design(), 10);
    ASSERT_TRUE(test);
    EXPECT_EQ(test->islands, 1);
    EXPECT_EQ(test->pieces, 1);
    EXPECT_TRUE(test->opening(3, 3));
    EXPECT_EQ(std::count(test->ring.begin(), test->ring.end(), 1), 25 - 9);
}

}  // namespace
}  // namespace snug
