#include "snug/space/spread_items.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/box.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

/// How far apart they are along an axis; below 0 where they overlap along it.
double apart(const Box3d& a, const Box3d& b, int axis) {
    return std::max(a.min[axis] - b.max[axis], b.min[axis] - a.max[axis]);
}

bool overlap(const Box3d& a, const Box3d& b) {
    return apart(a, b, 0) < 0 && apart(a, b, 1) < 0 && apart(a, b, 2) < 0;
}

/// Rooms that do not overlap, in a case of 400 mm.
std::vector<Item> random_items(Random& random) {
    std::vector<Item> items;
    for (int tries = 0; tries < 60 && items.size() < 12; ++tries) {
        Item item;
        item.cut.clearance_mm = {};
        const Vec3d from{random.between(0, 300), random.between(0, 300), random.between(0, 300)};
        item.placement.bounds = {
            from, from + Vec3d{random.between(20, 100), random.between(20, 100), random.between(20, 100)}};
        const bool free = std::none_of(items.begin(), items.end(), [&](const Item& other) {
            return overlap(room_of(item), room_of(other));
        });
        if (free) items.push_back(item);
    }
    if (items.size() > 4 && random.integer(0, 1) == 1) items[0].group = items[1].group = "set";
    return items;
}

TEST(SpreadItems, LeaveSoMuchMoreBetweenNeighboursAndNeverPushTwoIntoEachOther) {
    const std::uint64_t seed = 31400;
    Random random(seed);
    int neighbours = 0;
    for (int i = 0; i < test::cases(2000, 100); ++i) {
        const std::vector<Item> items = random_items(random);
        const Vec3d more{0, random.between(0, 80), random.between(0, 80)};
        const std::vector<Vec3d> shifts = shifts_apart(items, more);
        ASSERT_EQ(shifts.size(), items.size());
        for (std::size_t a = 0; a < items.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                if (!items[a].group.empty() && items[a].group == items[b].group) {
                    EXPECT_EQ(shifts[a], shifts[b]);
                    continue;
                }
                const auto moved = [&](std::size_t item) {
                    const Box3d room = room_of(items[item]);
                    return Box3d{room.min + shifts[item], room.max + shifts[item]};
                };
                const Box3d before_a = room_of(items[a]), before_b = room_of(items[b]);
                const bool grouped = !items[a].group.empty() || !items[b].group.empty();
                EXPECT_TRUE(grouped || !overlap(moved(a), moved(b))) << "seed " << seed << ", case " << i;
                EXPECT_EQ(shifts[a].x, 0);
                for (const int axis : {1, 2}) {
                    const bool beside =
                        apart(before_a, before_b, 0) < 0 && apart(before_a, before_b, 3 - axis) < 0;
                    if (!beside || grouped) continue;
                    ++neighbours;
                    // The other axis is spread too: they may stand beside each other no longer.
                    if (apart(moved(a), moved(b), 3 - axis) >= 0) continue;
                    EXPECT_GE(apart(moved(a), moved(b), axis),
                              apart(before_a, before_b, axis) + more[axis] - 1e-9)
                        << "seed " << seed << ", case " << i;
                }
            }
    }
    EXPECT_GT(neighbours, test::cases(2000, 100));
}

}  // namespace
}  // namespace snug
