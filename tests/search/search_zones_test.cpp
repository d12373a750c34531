#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/search/direction_map.h"
#include "snug/search/greedy_climb.h"
#include "snug/search/placement_search.h"
#include "snug/search/search_design.h"
#include "snug/search/searched_zones.h"
#include "snug/space/place_items.h"

#include "tests/support/cases.h"
#include "tests/support/kit_to_arrange.h"
#include "tests/support/random_zone.h"
#include "tests/support/sampled_cloud.h"
#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

// What searches and arrangements name with zones is what the method then makes of it.

namespace snug {
namespace {

using test::KitToArrange;
using test::Random;

struct Zoned {
    Design design;
    Object object;
};

/// A random soup with one to three zones, of which one at least keeps foam off; some hold it all and are
/// refused.
Zoned random_zoned(Random& random) {
    Zoned soup;
    soup.design.object.units = Unit::mm;
    soup.design.space.block_mm = {random.between(6, 20), random.between(6, 20), random.between(6, 20)};
    const Vec3d size{random.between(30, 80), random.between(30, 80), random.between(30, 80)};
    const Mesh mesh = test::random_soup(random, size, random.integer(6, 20));
    soup.design.space.blocks = test::roomy_design(mesh, soup.design.space.block_mm).space.blocks;
    if (random.chance(0.5))
        soup.design.cut.clearance_mm = test::random_clearance(random, soup.design.space.block_mm);
    soup.design.cut.cut_on_touch = random.chance(0.2);
    if (random.chance(0.3)) soup.design.cut.liner_mm = random.between(0, 3);
    soup.object = prepare(mesh, soup.design).value();
    prepare_for_many(soup.object);
    Zones& zones = soup.design.protection.zones;
    for (int i = random.integer(1, 3); i > 0; --i) zones.push_back(test::random_zone(random, soup.object));
    if (zones.size() > 1 && random.chance(0.3)) {
        zones.front().keep_off_mm = 0;
        zones.front().press_kpa = 2;
    }
    soup.design.space.wall_mm = equal_walls(random.between(0, 30));
    return soup;
}

void expect_as_packed(const Object& object, Design design, const FoundPlacement& found, const Walls& walls) {
    design.placement = {found.rotation_deg, found.offset_mm};
    const auto packing = pack(object, design);
    ASSERT_TRUE(packing && packing->foams);
    EXPECT_EQ(packing->fit.cut_blocks, found.cut_blocks);
    for (std::size_t side = 0; side < 6; ++side) EXPECT_GE(packing->fit.wall_mm[side], walls[side]) << side;
}

TEST(SearchZones, APlacementCutsWhatPackCutsAndKeepsItsWalls) {
    int searched = 0, better = 0;
    const int soups = test::cases(24, 6);
    for (int seed = 0; seed < soups; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 7100);
        const Zoned soup = random_zoned(random);
        const auto zones = searched_zones(soup.object, soup.design);
        const auto before = pack(soup.object, soup.design);
        ASSERT_EQ(zones.has_value(), before.has_value());
        if (!zones || !before->foams) continue;
        const auto exact = exact_cut(*soup.object.prepared, before->space, soup.design.cut, {}, {},
                                     before->available, *zones);
        ASSERT_TRUE(exact);
        EXPECT_EQ(exact->cut_blocks, before->fit.cut_blocks);
        EXPECT_EQ(exact->wall_mm, before->fit.wall_mm);
        EXPECT_EQ(exact->fill_ratio, before->fit.fill_ratio);
        auto search = PlacementSearch::start(soup.object.mesh, *soup.object.prepared, soup.design,
                                             before->space, 3, before->available, *zones);
        ASSERT_TRUE(search);
        EXPECT_EQ(search->origin().cut_blocks, before->fit.cut_blocks);
        run(*search, 500);
        Walls walls = *soup.design.space.wall_mm;
        for (std::size_t side = 0; side < 6; ++side)
            walls[side] = std::min(walls[side], before->fit.wall_mm[side]);
        for (const FoundPlacement& found : search->distinct())
            expect_as_packed(soup.object, soup.design, found, walls);
        ++searched;
        better += search->best().cut_blocks < before->fit.cut_blocks;

        const auto climb = greedy_climb(soup.object.mesh, soup.design, before->space, {}, *zones);
        ASSERT_TRUE(climb);
        expect_as_packed(soup.object, soup.design, {climb->rotation_deg, {}, climb->cut_blocks, 0, 0}, walls);
    }
    EXPECT_GT(searched, soups / 2);
    EXPECT_GT(better, searched / 2);
}

TEST(SearchZones, ACaseIsTheOneThatPackFitsToTheItemAndItsZones) {
    int fitted = 0, larger = 0;
    const int soups = test::cases(24, 6);
    for (int seed = 0; seed < soups; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 7200);
        Zoned soup = random_zoned(random);
        soup.design.space.blocks.reset();
        Design found = soup.design;
        const auto report = search_design(soup.object, found, {true, false, 0});
        if (!report) {  // a zone that holds all of it
            EXPECT_EQ(report.error().kind, ErrorKind::usage);
            continue;
        }
        const Packing packing = pack(soup.object, found).value();
        ASSERT_TRUE(packing.foams);
        EXPECT_EQ(packing.fit.cut_blocks, report->cut_blocks);
        // Of a fitted space an item may reach a hundredth of a millimetre into its walls.
        if (!found.cut.cut_on_touch) test::expect_walls(packing, soup.design);
        Design open = soup.design;
        open.placement.rotation_deg = found.placement.rotation_deg;
        EXPECT_EQ(pack(soup.object, open)->space.blocks, packing.space.blocks);
        open.protection.zones.clear();
        larger += pack(soup.object, open)->space.blocks != packing.space.blocks;
        // Then turned in it.
        const auto turned = search_design(soup.object, found, {false, true, 300});
        ASSERT_TRUE(turned);
        const Packing again = pack(soup.object, found).value();
        ASSERT_TRUE(again.foams);
        EXPECT_EQ(again.fit.cut_blocks, turned->cut_blocks);
        if (!found.cut.cut_on_touch) test::expect_walls(again, soup.design);
        ++fitted;
    }
    EXPECT_GT(fitted, soups / 2);
    EXPECT_GT(larger, fitted / 3);
}

TEST(SearchZones, AMapOfDirectionsNamesWhatPackCuts) {
    int looked_at = 0;
    for (int seed = 0; seed < test::cases(6, 2); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 7300);
        Zoned soup = random_zoned(random);
        const auto zones = searched_zones(soup.object, soup.design);
        if (!zones) continue;
        if (seed % 2 == 0) soup.design.space.blocks.reset();
        const Packing packing = pack(soup.object, soup.design).value();
        DirectionMap map(soup.object.mesh, *soup.object.prepared, soup.design, packing.space, 20,
                         packing.available, *zones);
        while (map.passes() < 2) map.step();
        for (const DirectionCut& cut : map.cuts()) {
            if (cut.cut_blocks < 0) continue;
            ++looked_at;
            expect_as_packed(soup.object, soup.design,
                             {cut.rotation_deg, cut.offset_mm, cut.cut_blocks, 0, 0},
                             *soup.design.space.wall_mm);
        }
    }
    EXPECT_GT(looked_at, 10);
}

TEST(SearchZones, AKitKeepsWallsAndWhatIsBetweenItsItemsAndTheirZones) {
    int arranged_kits = 0, in_layers = 0, refused = 0, zoned = 0;
    const int kits = test::cases(30, 10);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 7400);
        KitToArrange kit = test::random_kit_to_arrange(random);
        for (ItemOptions& item : kit.design.items)
            for (int i = random.integer(0, 2); i > 0; --i)
                item.zones.push_back(
                    test::random_zone(random, kit.objects[static_cast<std::size_t>(item.object)]));
        const auto design = checked(kit.design);
        ASSERT_TRUE(design);
        if (!place_items(kit.objects, *design)) continue;  // a zone that holds all of an item
        Design arranged = *design;
        const auto found = arrange(kit.objects, arranged, true, 1'000'000);
        if (!found) {
            EXPECT_EQ(found.error().kind, ErrorKind::does_not_fit) << text(found.error().message);
            ++refused;
            continue;
        }
        const Packing packing = pack(kit.objects, arranged).value();
        ASSERT_TRUE(packing.foams) << text(packing.findings.front().message);
        for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
        test::expect_room_between(packing, kit);
        test::expect_walls(packing, *design);
        const double volume = static_cast<double>(packing.space.block_count()) * packing.space.block_volume();
        EXPECT_NEAR(found->volume_mm3, volume, 1e-6 * volume);
        ++arranged_kits;
        in_layers += packing.foams->layers() > 1;
        zoned += !packing.zone_cuts.empty();
    }
    EXPECT_GT(arranged_kits, kits / 3);
    EXPECT_GT(zoned, arranged_kits / 2);
    EXPECT_GT(in_layers, 0);
    EXPECT_LT(refused, kits / 3);
}

/// Two cubes one above the other, of which the lower keeps foam 45 mm off its top.
KitToArrange two_layers() {
    KitToArrange kit;
    kit.design.object.units = Unit::mm;
    kit.design.space.block_mm = {10, 10, 10};
    kit.design.space.blocks.reset();
    kit.design.space.between_mm = 20;
    const Mesh cube = test::box_mesh({0, 0, 0}, {60, 60, 60});
    kit.objects = {prepare(cube, kit.design).value(), prepare(cube, kit.design).value()};
    Zone top;
    top.balls = {{{60, 30, 30}, 10}};
    top.keep_off_mm = 45;
    kit.design.items.assign(2, {});
    kit.design.items[0].zones = {top};
    kit.design.items[1].object = 1;
    kit.design.items[1].layer = 2;
    return kit;
}

TEST(SearchZones, LayersStandFartherApartWhereAZoneLiesBetweenThem) {
    KitToArrange kit = two_layers();
    Design arranged = kit.design;
    ASSERT_TRUE(arrange(kit.objects, arranged, true, 1'000'000));
    const Packing packing = pack(kit.objects, arranged).value();
    ASSERT_TRUE(packing.foams);
    EXPECT_EQ(packing.foams->layers(), 2);
    for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
    test::expect_room_between(packing, kit);
    const double apart = packing.items[1].placement.bounds.min.x - packing.items[0].placement.bounds.max.x;
    EXPECT_GE(apart, 45 + 20 - 0.02);
}

TEST(SearchZones, WhatIsLockedKeepsTheRoomOfItsZones) {
    KitToArrange kit = two_layers();
    kit.design.items[1].layer = 1;
    kit.design.items[0].zones.front().balls = {{{30, 60, 30}, 10}};
    kit.design.items[0].offset_mm = Vec3d{};
    kit.design.items[0].lock = true;
    Design arranged = kit.design;
    ASSERT_TRUE(arrange(kit.objects, arranged, true, 1'000'000));
    EXPECT_EQ(arranged.items[0], kit.design.items[0]);
    const Packing packing = pack(kit.objects, arranged).value();
    ASSERT_TRUE(packing.foams);
    for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
    test::expect_room_between(packing, kit);
    test::expect_walls(packing, kit.design);
}

TEST(SearchZones, OfACloudAreThoseOfItsStandInAndLeaveRoomForItsOwn) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {8, 8, 8};
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(16);
    Object cloud = prepare(test::sampled(test::box_mesh({0, 0, 0}, {50, 70, 90}), 4, 0.1), design).value();
    ASSERT_TRUE(cloud.is_cloud());
    prepare_for_many(cloud);
    Zone zone;
    zone.balls = {{{50, 35, 45}, 12}};
    zone.keep_off_mm = 30;
    design.protection.zones = {zone};
    Design found = design;
    ASSERT_TRUE(search_design(cloud, found, {true, true, 200}));
    const Packing packing = pack(cloud, found).value();
    ASSERT_TRUE(packing.foams);
    EXPECT_GT(packing.zone_cuts.front().blocks, 0);
    test::expect_walls(packing, design);
}

}  // namespace
}  // namespace snug
