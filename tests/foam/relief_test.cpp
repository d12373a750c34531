#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "snug/check/drop_sentence.h"
#include "snug/check/find_relief.h"
#include "snug/check/flat_drop.h"
#include "snug/check/protection.h"
#include "snug/design/known_foams.h"
#include "snug/foam/relief_islands.h"
#include "snug/make.h"

#include "tests/support/shapes.h"

// Items that stand on islands of their foam.

namespace snug {
namespace {

/// A flat box of 60 x 200 x 240 mm, with 50 mm of foam below it.
Design light_box(double kg) {
    Design design;
    design.object.units = Unit::mm;
    design.space.preset = "sheet-10";
    design.space.block_mm = {10, 5, 5};
    design.space.blocks = Vec3i{16, 64, 72};
    design.cut.clearance_mm = 0;
    design.workshop.mass_kg = kg;
    design.protection.foam = *find_foam(built_in_foams(), "ld33");
    design.protection.height_mm = 500;
    design.protection.fragility_g = 60;
    return design;
}

Object box_of(const Design& design) {
    return prepare(test::box_mesh({0, 0, 0}, {60, 200, 240}), design).value();
}

Packing packed(const Object& object, const Design& design) {
    auto packing = pack(object, *checked(design));
    EXPECT_TRUE(packing && packing->foams);
    return std::move(*packing);
}

bool warns(const Packing& packing, std::string_view code) {
    return std::any_of(packing.findings.begin(), packing.findings.end(),
                       [&](const Finding& finding) { return finding.message.code == code; });
}

TEST(ReliefIslands, StandTowardsTheCornersAndAllElseUnderTheItemGoes) {
    Design design = light_box(2);
    const Object object = box_of(design);
    const Packing whole = packed(object, design);
    design.fit.relief = ReliefOptions{40, 55};
    const Packing relieved = packed(object, design);
    ASSERT_TRUE(relieved.relief);
    EXPECT_EQ(relieved.relief->islands.size(), 4U);
    EXPECT_EQ(relieved.relief->blocks, 4);
    const BlockMap &before = whole.foams->pieces[0], &after = relieved.foams->pieces[0];
    long long cut = 0, stand = 0;
    for (int j = 0; j < before.ny(); ++j)
        for (int k = 0; k < before.nz(); ++k) {
            const bool under = j >= 12 && j < 52 && k >= 12 && k < 60;
            const bool island = std::any_of(relieved.relief->islands.begin(), relieved.relief->islands.end(),
                                            [&](const ReliefIsland& each) { return each.has(j, k); });
            EXPECT_TRUE(under || !island);
            EXPECT_EQ(after(j, k).end, under && !island ? before(j, k).end - 4 : before(j, k).end);
            cut += before(j, k).blocks() - after(j, k).blocks();
            stand += island;
        }
    EXPECT_EQ(stand, 4 * 11 * 11);
    EXPECT_EQ(cut, relieved.relief->cut_blocks);
    EXPECT_EQ(relieved.fit.cut_blocks, whole.fit.cut_blocks + cut);
    EXPECT_EQ(whole.foams->pieces[1], relieved.foams->pieces[1]);
}

TEST(ReliefIslands, AreRefusedWhereTheyWouldNotCarry) {
    Design design = light_box(2);
    const Object object = box_of(design);
    const auto refuses = [&](std::string_view code) {
        const Packing packing = packed(object, design);
        EXPECT_FALSE(packing.relief);
        EXPECT_TRUE(warns(packing, code)) << code;
    };
    design.fit.relief = ReliefOptions{40, 50};  // less than 1.33 times as wide as high
    refuses("no_relief/slender");
    design.fit.relief = ReliefOptions{20, 55};  // of 50 mm of foam
    refuses("no_relief/depth");
    design.fit.relief = ReliefOptions{50, 70};  // nothing would be left below
    refuses("no_relief/depth");
    design.fit.relief = ReliefOptions{40, 130};  // no three of them
    refuses("no_relief/room");
    design.fit.relief = ReliefOptions{40, 55};
    design.protection.centre_mm = Vec3d{30, 100, 239};  // nearly at its side, beyond every island's middle
    refuses("no_relief/room");
    design.protection.centre_mm.reset();
    design.space.preset = "slit-10";
    refuses("no_relief/foam");
    design.space.preset = "sheet-10";
    design.workshop.work = Workshop::print;
    refuses("no_relief/foam");
    design.workshop.work = Workshop::none;
    // A zone under one corner leaves three, and under all of it none.
    Zone zone;
    zone.balls.push_back({{0, 20, 20}, 15});
    zone.keep_off_mm = 5;
    design.protection.zones = {zone};
    const Packing three = packed(object, design);
    ASSERT_TRUE(three.relief);
    for (const ReliefIsland& island : three.relief->islands)
        EXPECT_FALSE(island.has(15, 15)) << "an island stands under the zone";
}

/// What the box meets on its floor on islands, beside what lies between them, on a base of so many mm.
double floor_g(double kg, double island_mm, double base_mm) {
    const double islands = 4 * island_mm * island_mm, between = 200 * 240 - islands;
    const Pads ahead({{40 + base_mm, 0, islands, 0, 0}, {10, 40, between, 0, 0}}), behind({});
    const Cushioned box{&ahead, &behind, std::numeric_limits<double>::infinity(), kg};
    const auto stop = flat_drop(box, StressCurve(find_foam(built_in_foams(), "ld33")->curve), 500, 25);
    return stop ? shock_g(*stop, kg) : 0;
}

TEST(ReliefIslands, TheRangeTakesInBothWaysThatTheBaseMayGiveWay) {
    Design design = light_box(3);
    const Object object = box_of(design);
    design.fit.relief = ReliefOptions{40, 60};
    Packing packing = packed(object, design);
    const auto held = protection(std::span(&object, 1), packing, *checked(design));
    ASSERT_TRUE(held);
    const FaceShock& floor = held->items.front().faces[kFloor];
    ASSERT_TRUE(floor.g_model && floor.g_low && floor.g_high);
    const double gives = floor_g(3, 60, 10), stiff = floor_g(3, 60, 0);
    ASSERT_GT(gives, 0);
    ASSERT_GT(stiff, gives);
    EXPECT_NEAR(*floor.g_model, gives, 0.01 * gives);
    EXPECT_LE(*floor.g_low, 0.8 * gives * 1.01);
    EXPECT_GE(*floor.g_high, 1.2 * stiff * 0.99);
    ASSERT_TRUE(held->items.front().relief);
}

TEST(ReliefIslands, AreOfferedWhereTheyHelpAndThenDoWhatWasSaid) {
    Design design = light_box(3);
    const Object object = box_of(design);
    const auto made = [&](const Design& wanted) {
        std::vector<Object> objects{object};
        Project project;
        project.design = *checked(wanted);
        project.objects.resize(1);
        return make(objects, project).value();
    };
    const Made first = made(design);
    const double before = *first.packing.protection->items.front().faces[kFloor].g_high;
    ASSERT_GT(before, 60);
    const auto offer = std::find_if(first.packing.findings.begin(), first.packing.findings.end(),
                                    [](const Finding& finding) { return finding.code() == "relief_offer"; });
    ASSERT_NE(offer, first.packing.findings.end());
    const std::string said = text(offer->message);
    const auto flag = said.find("--relief ");
    ASSERT_NE(flag, std::string::npos) << said;
    double height = 0, island = 0;
    ASSERT_EQ(std::sscanf(said.c_str() + flag, "--relief %lfx%lf", &height, &island), 2);
    design.fit.relief = ReliefOptions{height, island};
    const Made second = made(design);
    ASSERT_TRUE(second.packing.relief);
    const FaceShock& floor = second.packing.protection->items.front().faces[kFloor];
    ASSERT_TRUE(floor.g_high);
    EXPECT_LT(*floor.g_high, before);
    EXPECT_NE(said.find(text(drop_range(floor))), std::string::npos) << said << text(drop_range(floor));
    EXPECT_FALSE(warns(second.packing, "relief_bottoms"));
    EXPECT_TRUE(warns(second.packing, "relief"));
}

}  // namespace
}  // namespace snug
