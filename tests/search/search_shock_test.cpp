#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/flat_drop.h"
#include "snug/check/gravity.h"
#include "snug/design/known_foams.h"
#include "snug/search/protecting_walls.h"
#include "snug/search/search_design.h"
#include "snug/search/shock_margins.h"
#include "snug/search/turn.h"

#include "tests/support/cases.h"
#include "tests/support/kit_to_arrange.h"
#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

// Searches and arrangements that weigh what is met in a drop.

namespace snug {
namespace {

using test::KitToArrange;
using test::Random;

void weigh_shocks(Design& design) {
    design.object.units = Unit::mm;
    design.search.weight.fill(0);
    design.search.weight[static_cast<std::size_t>(Objective::shock)] = 1;
    design.protection.foam = *find_foam(built_in_foams(), "ld33");
    design.protection.height_mm = 500;
    design.protection.fragility_g = 50;
    design.workshop.mass_kg = 1.5;
}

struct Dropped {
    Design design;
    Object object;
    [[nodiscard]] PackIt pack_it() const {
        return [this](const Design& tried) { return pack(object, tried); };
    }
    [[nodiscard]] double worst(const Design& of) const {
        const auto found = packed_shocks(std::span(&object, 1), of, pack_it());
        EXPECT_TRUE(found);
        return found ? worst_margin(found->protection) : 0;
    }
    [[nodiscard]] Design searched(long long evaluations) const {
        Design found = design;
        const auto report = search_design(object, found, {false, true, evaluations, pack_it()});
        EXPECT_TRUE(report) << text(report.error().message);
        return found;
    }
};

/// In 28 x 16 x 16 blocks that are 10 x 15 x 15 mm.
Dropped dropped(const Mesh& mesh) {
    Dropped all;
    weigh_shocks(all.design);
    all.design.space.block_mm = {10, 15, 15};
    all.design.space.blocks = Vec3i{28, 16, 16};
    all.object = prepare(mesh, all.design).value();
    prepare_for_many(all.object);
    return all;
}

/// A box with a smaller one on it and another beside it.
Mesh stepped(Random& random) {
    const auto mm = [&](double low, double high) { return random.between(low, high); };
    Mesh mesh = test::box_mesh({0, 0, 0}, {mm(40, 80), mm(50, 80), mm(50, 90)});
    for (int i = 0; i < 2; ++i) {
        const Vec3d from{mm(0, 30), mm(0, 30), mm(0, 40)};
        const Mesh more = test::box_mesh(from, from + Vec3d{mm(30, 70), mm(20, 60), mm(20, 60)});
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
        for (Triangle t : more.triangles)
            mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return mesh;
}

TEST(ShockEstimate, IsNearTheFullCalculation) {
    const std::uint64_t seed = 51800;
    Random random(seed);
    int compared = 0, far_off = 0;
    double least = 9, most = 0;
    for (int i = 0; i < test::cases(16, 4); ++i) {
        const Mesh mesh = i % 4 == 0 ? *sample("camera") : i % 4 == 1 ? *sample("torus") : stepped(random);
        const Dropped all = dropped(mesh);
        const DesignSpace space = test::space_of(all.design);
        const auto margins = ShockMargins::start(all.object, all.design, space, all.pack_it());
        ASSERT_TRUE(margins);
        for (int place = 0; place < 4; ++place) {
            const Vec3d rotation = place == 0 ? Vec3d{}
                                              : Vec3d{random.between(-180, 180), 90.0 * random.integer(0, 3),
                                                      place == 1 ? 0 : random.between(-180, 180)};
            const Vec3d offset{random.between(-5, 5), random.between(-20, 20), random.between(-20, 20)};
            const auto exact = exact_cut(*all.object.prepared, space, all.design.cut, rotation, offset,
                                         all_blocks(space.blocks));
            if (!exact) continue;
            const auto estimate = margins->estimated(*exact);
            const auto full = margins->in_full(rotation, offset);
            ASSERT_TRUE(full);
            for (std::size_t side = 0; side < 6; ++side) {
                const double ratio = estimate[side] / (*full)[side];
                if ((*full)[side] < kNoMargin && estimate[side] < kNoMargin) {
                    least = std::min(least, ratio);
                    most = std::max(most, ratio);
                    ++compared;
                }
                far_off += (*full)[side] > 2.3 * kNoMargin && estimate[side] < kNoMargin;
            }
        }
    }
    EXPECT_GT(compared, 40);
    EXPECT_GT(least, 0.75) << "seed " << seed;
    EXPECT_LT(most, 1.5) << "seed " << seed;
    EXPECT_EQ(far_off, 0) << "seed " << seed;
    std::printf("estimated margins are %.3f to %.3f times those in full, seed %llu\n", least, most,
                static_cast<unsigned long long>(seed));
}

TEST(SearchShock, MovesABoxToWhereItsWorstSideMeetsLess) {
    Dropped all = dropped(test::box_mesh({0, 0, 0}, {60, 90, 90}));
    all.design.placement.offset_mm = {30, -30, 0};
    const double before = all.worst(all.design);
    for (const Turns turns : {Turns::none, Turns::upright}) {
        all.design.search.turns = turns;
        const Design found = all.searched(2500);
        EXPECT_LT(all.worst(found), before * 0.9);
        // In the middle of what is there, to a block.
        EXPECT_LE(std::fabs(found.placement.offset_mm.x), 10);
        EXPECT_LE(std::fabs(found.placement.offset_mm.y), 15);
    }
}

TEST(SearchShock, FindsNothingWorseThanTheStart) {
    const std::uint64_t seed = 61900;
    Random random(seed);
    int better = 0;
    const int all_cases = test::cases(10, 3);
    for (int i = 0; i < all_cases; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(i));
        Dropped all = dropped(stepped(random));
        all.design.placement.rotation_deg = {random.between(-180, 180), 0, 90.0 * random.integer(0, 3)};
        all.design.placement.offset_mm = {random.between(-20, 20), random.between(-20, 20), 0};
        all.design.workshop.mass_kg = random.between(0.5, 6);
        all.design.search.turns = i % 3 == 0 ? Turns::any : Turns::upright;
        all.design.search.seed = static_cast<std::uint32_t>(i);
        const double before = all.worst(all.design);
        const double after = all.worst(all.searched(2000));
        EXPECT_LE(after, before);
        better += after < before;
    }
    EXPECT_GT(better, all_cases / 2);
}

TEST(SearchShock, TurnsAsFarAsItMay) {
    Random random(4);
    Dropped all = dropped(stepped(random));
    all.design.placement.rotation_deg = {20, 30, 40};
    const Rotation given = rotation_from_euler(all.design.placement.rotation_deg);
    const auto turned = [&](Turns turns) {
        all.design.search.turns = turns;
        return rotation_from_euler(all.searched(2000).placement.rotation_deg);
    };
    EXPECT_EQ(turned(Turns::none).row, given.row);
    // What lay along x lies there still.
    EXPECT_NEAR(dot(turned(Turns::upright).row[0], given.row[0]), 1, 1e-6);
    const Rotation quarter = turned(Turns::quarter);
    double along = 0;
    for (const Vec3d& row : given.row) along = std::max(along, std::fabs(dot(quarter.row[0], row)));
    EXPECT_NEAR(along, 1, 1e-6);
    all.design.search.upright = Upright::plus_z;
    EXPECT_NEAR(turned(Turns::none)({0, 0, 1}).x, 1, 1e-6);
}

TEST(SearchShock, IsTheSameOnAnyNumberOfThreads) {
    Random random(9);
    const Dropped all = dropped(stepped(random));
    std::vector<Design> found;
    for (const std::size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        found.push_back(all.searched(2000));
    }
    EXPECT_EQ(found[0], found[1]);
}

TEST(SearchShock, SaysWhatIsMissing) {
    const Dropped all = dropped(test::box_mesh({0, 0, 0}, {60, 90, 90}));
    for (int lacking = 0; lacking < 4; ++lacking) {
        Design design = all.design;
        if (lacking == 0) design.workshop.mass_kg.reset();
        if (lacking == 1) design.protection.height_mm.reset();
        if (lacking == 2) design.protection.fragility_g.reset();
        if (lacking == 3) design.protection.foam.reset();
        const auto report = search_design(all.object, design, {false, true, 100, all.pack_it()});
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().kind, ErrorKind::usage);
        EXPECT_EQ(report.error().message.code, "protect.lacking");
        EXPECT_NE(text(report.error().message).find("searches that weigh shocks"), std::string::npos);
        std::vector<Object> objects{all.object};
        design.items.assign(2, {});
        const auto arranged = arrange(objects, design, true, 1000);
        ASSERT_FALSE(arranged);
        EXPECT_EQ(arranged.error().message.code, "protect.lacking");
    }
}

TEST(SearchShock, OfArrangementsOfOneVolumeTheOneThatMeetsLessIsTaken) {
    int better = 0;
    for (const int items : {2, 3, 4, 5, 6}) {
        SCOPED_TRACE(items);
        KitToArrange kit = test::sample_kit(items);
        weigh_shocks(kit.design);
        kit.design.workshop.mass_kg.reset();
        for (std::size_t i = 0; i < kit.design.items.size(); ++i)
            kit.design.items[i].mass_kg = 0.4 + 0.3 * static_cast<double>(i);
        ArrangeWatch watch;
        watch.pack_it = [&](const Design& tried) { return pack(kit.objects, tried); };
        const auto worst = [&](const Design& design) {
            return worst_margin(packed_shocks(kit.objects, design, watch.pack_it).value().protection);
        };
        Design plain = kit.design, weighed = kit.design;
        plain.search.weight = SearchOptions().weight;
        const auto one = arrange(kit.objects, plain, true, 2'000'000, watch);
        const auto other = arrange(kit.objects, weighed, true, 2'000'000, watch);
        ASSERT_TRUE(one && other);
        EXPECT_EQ(one->volume_mm3, other->volume_mm3);
        EXPECT_LE(worst(weighed), worst(plain));
        better += worst(weighed) < worst(plain);
        const Packing packing = pack(kit.objects, weighed).value();
        for (const Finding& finding : packing.findings) EXPECT_NE(finding.code(), "items_near");
        for (const double wall : packing.fit.wall_mm) EXPECT_GE(wall, 50);
    }
    EXPECT_GT(better, 0);
}

TEST(Margins, OfAFlatBoxRiseWithTheHeightBeyondWhatTheFoamStops) {
    Dropped all = dropped(test::box_mesh({0, 0, 0}, {60, 90, 90}));
    double before = 0;
    bool told = false, bottomed = false;
    for (double height = 100; height < 6000; height *= 1.3) {
        all.design.protection.height_mm = height;
        const auto found = packed_shocks(std::span(&all.object, 1), all.design, all.pack_it());
        ASSERT_TRUE(found);
        const FaceShock& floor = found->protection.items.front().faces[kFloor];
        const double here = found->protection.margins()[kFloor];
        EXPECT_GT(here, before) << height;
        EXPECT_EQ(here >= kNoMargin, !floor.g_high.has_value());
        if (floor.g_high) {
            EXPECT_EQ(here, *floor.g_high / 50);
        }
        told = told || floor.g_high;
        bottomed = bottomed || floor.bottoms;
        before = here;
    }
    EXPECT_TRUE(told && bottomed);
}

TEST(Margins, WhatFoamLacksOfAFallIsTheEnergyThatItCannotTakeUp) {
    const StressCurve curve(find_foam(built_in_foams(), "ld33")->curve);
    const double thickness = 50, gap = 4, area = 6000, kg = 2.5;
    const Pads pads({{thickness, gap, area, 0, 0}});
    const Cushioned item{&pads, nullptr, std::numeric_limits<double>::infinity(), kg};
    const double travel = gap + thickness * curve.greatest_strain();
    const double joule = curve.corners().back().energy * area * thickness * 1e-6;
    for (double height = 50; height < 5000; height *= 1.5) {
        const double fall = kg * kStandardGravity * (height + travel) * 1e-3;
        EXPECT_NEAR(lacking_share(item, curve, height), std::max(0.0, 1 - joule / fall), 1e-9);
        EXPECT_EQ(lacking_share(item, curve, height) > 0, !flat_drop(item, curve, height, 0));
    }
    EXPECT_EQ(lacking_share({nullptr, nullptr, 0, kg}, curve, 100), 1);
}

TEST(SearchShock, LaysAThingInOpenCountsWhereNoneOfTheUsualWaysToLieMeetsLess) {
    const std::uint64_t seed = 51850;
    Random random(seed);
    for (int i = 0; i < test::cases(3, 1); ++i) {
        Dropped all = dropped(stepped(random));
        all.design.space.blocks.reset();
        all.design.space.wall_mm = equal_walls(60);
        for (const Turns turns : {Turns::none, Turns::upright, Turns::any}) {
            all.design.search.turns = turns;
            const Design found = all.searched(600);
            const double least = all.worst(found);
            double usual = all.worst(all.design);
            for (const Vec3d turned : {Vec3d{45, 0, 0}, Vec3d{90, 0, 0}, Vec3d{0, 90, 0}, Vec3d{0, 0, 90}}) {
                if (turns == Turns::none || (turns == Turns::upright && turned.x == 0)) continue;
                Design tried = all.design;
                tried.placement.rotation_deg = turned;
                usual = std::min(usual, all.worst(tried));
            }
            EXPECT_LE(least, usual * 1.0001) << "seed " << seed << ", case " << i;
            if (turns == Turns::none) {
                EXPECT_EQ(found.placement.rotation_deg, Vec3d());
            }
        }
    }
}

/// Boxes of random sizes in a grid along y and z, a foam of 20 mm between them.
Design grid_of_boxes(Random& random, std::vector<Object>& objects) {
    Design design;
    weigh_shocks(design);
    design.space.blocks.reset();
    design.space.block_mm = {10, 10, 10};
    design.protection.fragility_g = random.between(60, 120);
    design.protection.height_mm = random.between(200, 400);
    const int rows = random.integer(1, 2), columns = random.integer(2, 3);
    design.items.clear();
    for (int i = 0; i < rows * columns; ++i) {
        const Vec3d size{random.between(40, 60), random.between(60, 100), random.between(60, 100)};
        objects.push_back(prepare(test::box_mesh({0, 0, 0}, size), design).value());
        prepare_for_many(objects.back());
        ItemOptions item;
        item.object = i;
        item.mass_kg = random.between(0.8, 2.5);
        item.offset_mm = Vec3d{0, i / columns * 120.0, i % columns * 120.0};
        design.items.push_back(item);
    }
    return design;
}

TEST(ProtectingWalls, HoldEveryItemAndNoSideCouldBeMuchThinner) {
    const std::uint64_t seed = 51900;
    Random random(seed);
    int held = 0, moved = 0, thinner_held = 0, thinner_tried = 0;
    for (int i = 0; i < test::cases(6, 2); ++i) {
        std::vector<Object> objects;
        const Design design = grid_of_boxes(random, objects);
        const PackIt pack_it = [&](const Design& tried) { return pack(objects, tried); };
        const auto found = protecting_walls(objects, design, pack_it);
        if (!found) {
            EXPECT_EQ(found.error().kind, ErrorKind::does_not_fit) << text(found.error().message);
            continue;
        }
        ++held;
        moved += found->items != design.items;
        const auto margin = [&](const Design& of) {
            const auto dropped = packed_shocks(objects, of, pack_it);
            EXPECT_TRUE(dropped);
            for (const Finding& finding : dropped->packing.findings)
                EXPECT_TRUE(finding.message.code != "near_items" && finding.message.code != "items_meet")
                    << text(finding.message);
            return worst_margin(dropped->protection);
        };
        EXPECT_LE(margin(*found), 1) << "seed " << seed << ", case " << i;
        for (std::size_t side = 0; side < 6; ++side) {
            Design thinner = *found;
            double& wall = (*thinner.space.wall_mm)[side];
            if (wall <= 25) continue;  // as thin as its data
            wall -= 10;                // a whole block
            ++thinner_tried;
            const auto dropped = packed_shocks(objects, thinner, pack_it);
            thinner_held += dropped && worst_margin(dropped->protection) <= 1;
        }
    }
    EXPECT_GT(held, 0);
    std::printf("%d held, %d moved apart; of %d walls thinner by a block %d would have held, seed %llu\n",
                held, moved, thinner_tried, thinner_held, static_cast<unsigned long long>(seed));
    EXPECT_LE(thinner_held, thinner_tried / 5) << "seed " << seed;
}

}  // namespace
}  // namespace snug
