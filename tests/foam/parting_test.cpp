#include "snug/foam/parting.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace snug {
namespace {

using Run = CutRun;
constexpr Run kFree{};

BlockMap literal(std::initializer_list<std::initializer_list<Run>> rows) {
    BlockMap blocks(static_cast<int>(rows.size()), static_cast<int>(rows.begin()->size()));
    int j = 0;
    for (const auto& row : rows) {
        int k = 0;
        for (const Run run : row) blocks(j, k++) = run;
        ++j;
    }
    return blocks;
}

TEST(Parting, OneCutColumnPartsInItsMiddle) {
    // Any level from 2 to 6 gives steps of 4 blocks on each side: the middle of the object wins.
    const BlockMap blocks = literal({{kFree, kFree, kFree}, {kFree, {2, 6}, kFree}, {kFree, kFree, kFree}});
    const DesignSpace space{{8, 3, 3}, {10, 10, 10}};
    EXPECT_EQ(auto_parting_level(blocks, space, {{-20, -5, -5}, {20, 5, 5}}), 4);
    EXPECT_DOUBLE_EQ(stepped_wall_area(blocks, space, 4), 4 * 4 * 100.0);
    EXPECT_DOUBLE_EQ(stepped_wall_area(blocks, space, 7), 4 * (5 + 1) * 100.0);
}

TEST(Parting, TheLowerFoamStillHoldsAFlatObject) {
    // One block high: levels 3 and 4 are equal, but at 3 the lower foam would be a plain floor.
    const BlockMap blocks = literal({{kFree, kFree, kFree}, {kFree, {3, 4}, kFree}, {kFree, kFree, kFree}});
    EXPECT_EQ(auto_parting_level(blocks, {{8, 3, 3}, {10, 10, 10}}, {{-10, -5, -5}, {-9, 5, 5}}), 4);
}

TEST(Parting, AWideFlangeDrawsThePartingToItself) {
    // A disc with a thin stem below: the flange has the most sides towards free columns.
    const BlockMap blocks = literal({{kFree, kFree, kFree, kFree, kFree},
                                     {kFree, {5, 6}, {5, 6}, {5, 6}, kFree},
                                     {kFree, {5, 6}, {1, 6}, {5, 6}, kFree},
                                     {kFree, {5, 6}, {5, 6}, {5, 6}, kFree},
                                     {kFree, kFree, kFree, kFree, kFree}});
    const int level = auto_parting_level(blocks, {{8, 5, 5}, {10, 10, 10}}, {{-30, -15, -15}, {20, 15, 15}});
    EXPECT_EQ(level, 5);
}

TEST(Parting, AnUntouchedSpacePartsInTheMiddle) {
    EXPECT_EQ(auto_parting_level(BlockMap(3, 3), {{8, 3, 3}, {10, 10, 10}}, {}), 4);
}

TEST(Parting, TheChosenLevelHasTheLeastSteppedWallAreaOfItsRange) {
    for (int seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(static_cast<std::uint64_t>(seed));
        const DesignSpace space{{random.integer(1, 20), random.integer(1, 8), random.integer(1, 8)},
                                {random.between(1, 20), random.between(1, 20), random.between(1, 20)}};
        BlockMap blocks(space.blocks.y, space.blocks.z);
        int lowest = space.blocks.x, highest = 0;
        for (CutRun& run : blocks) {
            if (random.chance(0.4)) continue;
            const int first = random.integer(0, space.blocks.x - 1);
            run = {static_cast<std::int16_t>(first),
                   static_cast<std::int16_t>(random.integer(first + 1, space.blocks.x))};
            lowest = std::min<int>(lowest, run.first);
            highest = std::max<int>(highest, run.end);
        }
        if (lowest > highest) continue;
        const Box3d object{{space.face(0, lowest), 0, 0}, {space.face(0, highest), 0, 0}};
        const int chosen = auto_parting_level(blocks, space, object);
        ASSERT_GE(chosen, lowest);
        ASSERT_LE(chosen, highest);
        const double least = stepped_wall_area(blocks, space, chosen);
        for (int level = lowest; level <= highest; ++level) {
            const double area = stepped_wall_area(blocks, space, level);
            ASSERT_GE(area, least * (1 - 1e-9));
            const bool equal = area <= least * (1 + 1e-12), holds = level > lowest;
            const double middle = object.centre().x;
            if (!equal || !holds) continue;
            ASSERT_LE(std::fabs(space.face(0, chosen) - middle),
                      std::fabs(space.face(0, level) - middle) + 1e-9);
        }
    }
}

}  // namespace
}  // namespace snug
