#include <algorithm>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "snug/foam/item_cuts.h"
#include "snug/make.h"
#include "snug/space/place_items.h"

#include "tests/support/broken_foams.h"
#include "tests/support/cases.h"
#include "tests/support/shapes.h"
#include "tests/support/zoned_kit.h"

// Items that are lowered onto the foam below them.

namespace snug {
namespace {

using test::Random;

/// mm that are free under an item in the columns where it would lie on foam; infinite where there is none.
double least_free(const Item& item, const ObjectDepths& depths, const Packing& packing) {
    const HalfDepths& lower = depths.lower;
    const BlockMap own = block_map(lower.depths, packing.space, lower.reach);
    const Grid<Run>& below = packing.foams->pieces[static_cast<std::size_t>(item.layer - 1)];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t column = 0; column < own.size(); ++column)
        if (!own[column].none() && below[column].end == own[column].first)
            least = std::min(least, lower.depths[column].lowest - lower.reach.mm.x -
                                        packing.space.face(0, own[column].first));
    return least;
}

TEST(Settle, ItemsComeToLieOnFoamAndCutNoMoreOfIt) {
    int lowered = 0, lying = 0;
    const int kits = test::cases(120, 30);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 42000);
        test::ZonedKit kit = test::random_kit_with_zones(random);
        kit.design.fit = {};
        kit.design.fit.settle = true;
        const bool zones = random.chance(0.5);
        if (!zones)
            for (ItemOptions& item : kit.design.items) item.zones.clear();
        const auto design = checked(kit.design);
        ASSERT_TRUE(design) << text(design.error().message);
        const auto packing = pack(kit.objects, *design);
        if (!packing || !packing->foams) continue;
        auto items = packing->items;
        const auto settled = cut_items(kit.objects, items, packing->space);
        for (Item& item : items) settle(item, -item.settled_mm);
        const auto before = cut_items(kit.objects, items, packing->space);
        ASSERT_TRUE(settled && before);
        for (std::size_t i = 0; i < items.size(); ++i) {
            lowered += packing->items[i].settled_mm > 0;
            EXPECT_LT(packing->items[i].settled_mm, zones ? 1e9 : packing->space.block_mm.x);
            if (!zones)
                for (std::size_t column = 0; column < before->cuts[i].lower.size(); ++column) {
                    const CutRun was = before->cuts[i].lower[column], is = settled->cuts[i].lower[column];
                    if (was.none()) {
                        // A squeeze fit may cut nothing where it lies between two blocks' faces.
                        ASSERT_TRUE(is.none() || kit.design.cut.whole_clearance_mm().least() < 0);
                        continue;
                    }
                    ASSERT_EQ(was.first, is.first) << "column " << column;
                }
            const double free = least_free(packing->items[i], *settled->depths[i], *packing);
            // Where halves keep away differently, one of them may end before the other one's blocks.
            const Clearance clearance = kit.design.cut.whole_clearance_mm();
            if (!std::isinf(free) && !zones && clearance.same_in_both() && clearance.least() >= 0) {
                ++lying;
                EXPECT_LT(free, 0.106) << "layer " << packing->items[i].layer;
            }
        }
    }
    EXPECT_GT(lowered, kits);
    EXPECT_GT(lying, kits / 8);
}

TEST(Settle, IsTheSameAsPlacingThemThere) {
    Random random(7);
    for (int time = 0; time < test::cases(20, 8); ++time) {
        SCOPED_TRACE(time);
        Design design;
        design.object.units = Unit::mm;
        design.space.block_mm = {random.between(6, 25), 12, 15};
        design.space.blocks = Vec3i{12, 14, 12};
        design.placement.offset_mm = {random.between(-9, 9), random.between(-9, 9), 0};
        const Object object = prepare(test::random_soup(random, {50, 80, 70}, 6), design).value();
        design.fit.settle = true;
        const auto settled = pack(object, *checked(design));
        ASSERT_TRUE(settled && settled->foams);
        design.fit.settle = false;
        design.placement.offset_mm.x -= settled->items.front().settled_mm;
        const auto placed = pack(object, *checked(design));
        ASSERT_TRUE(placed && placed->foams);
        EXPECT_EQ(settled->foams->pieces, placed->foams->pieces);
        EXPECT_EQ(settled->foams->parting, placed->foams->parting);
    }
}

TEST(Settle, LockedItemsAndGroupsKeepTheirPlaces) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {20, 10, 10};
    design.space.blocks = Vec3i{10, 20, 30};
    std::vector<Object> objects;
    for (int i = 0; i < 4; ++i) {
        objects.push_back(prepare(test::box_mesh({0, 0, 0}, {30, 30, 30}), design).value());
        ItemOptions item;
        item.object = i;
        // All of them float, each at another height.
        item.offset_mm = Vec3d{3.0 + 2 * i, 0, -100 + 60.0 * i};
        if (i < 2) item.group = "pair";
        item.lock = i == 3;
        design.items.resize(static_cast<std::size_t>(i) + 1);
        design.items.back() = item;
    }
    design.fit.settle = true;
    const auto packing = pack(objects, *checked(design));
    ASSERT_TRUE(packing && packing->foams);
    EXPECT_EQ(packing->items[0].settled_mm, packing->items[1].settled_mm);
    EXPECT_GT(packing->items[0].settled_mm, 0);
    EXPECT_GT(packing->items[2].settled_mm, packing->items[0].settled_mm);
    EXPECT_EQ(packing->items[3].settled_mm, 0);
}

}  // namespace
}  // namespace snug
