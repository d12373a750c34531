#include "snug/fabricate/mill/mill.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/design/presets.h"
#include "snug/fabricate/mill/carved_stock.h"
#include "snug/fabricate/mill/gcode.h"
#include "snug/fabricate/mill/mill_allowed.h"
#include "snug/fabricate/mill/mill_plan.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/gcode_stock.h"
#include "tests/support/milled.h"
#include "tests/support/models.h"
#include "tests/support/print_design.h"

// What the cutter leaves is the foam, and nothing is left where the object is.

namespace snug {
namespace {

using test::carved;
using test::expect_milled;
using test::expect_no_more_lost_than_told;
using test::expect_sound;
using test::expect_the_blocks;
using test::GcodeProgram;
using test::GcodeStock;
using test::height_of;
using test::Lost;
using test::lost_of;
using test::milled_case;
using test::MilledCase;
using test::Random;
using test::text_of;

TEST(MillTest, NoFoamIsLeftWhereTheSamplesAreAndNoMoreIsLostThanTold) {
    Random random(1);
    for (const char* name : {"torus", "vase", "figurine", "camera"}) {
        SCOPED_TRACE(name);
        expect_milled(milled_case(*sample(name), 70, 12), {}, random);
    }
}

TEST(MillTest, NoFoamIsLeftWhereRealObjectsAre) {
    int objects = 0;
    Random random(2);
    for (const char* name : {"stanford-bunny.obj", "armadillo.obj", "spot.obj", "teapot.obj", "cow.obj",
                             "beetle-alt.obj", "camelhead.off", "screwdriver.off"}) {
        const auto bytes = test::model_file(name);
        if (!bytes) continue;
        ++objects;
        SCOPED_TRACE(name);
        MillOptions options;
        options.cutter_mm = 4;
        expect_milled(milled_case(*read_mesh(*bytes, name), 60, 12), options, random);
    }
    if (objects == 0) GTEST_SKIP() << "the shared models are not there";
}

/// An object in any position, in a case of any shape, with clearances of its own on six sides, notches, ribs.
std::optional<MilledCase> random_milled_case(Random& random) {
    static const std::vector<const char*> names{"torus",    "figurine",           "vase",         "camera",
                                                "spot.obj", "stanford-bunny.obj", "armadillo.obj"};
    const char* name = names[static_cast<std::size_t>(random.integer(0, static_cast<int>(names.size()) - 1))];
    const auto bytes = test::model_file(name);
    const auto made = sample(name);
    if (!bytes && !made) return {};
    MilledCase result;
    Design& design = result.design;
    apply(*find_preset(built_in_presets(), "mill"), design);
    design.space.wall_mm = equal_walls(0);
    design.object.longest_mm = random.between(40, 60);
    for (const int axis : {0, 1, 2}) design.placement.rotation_deg[axis] = random.between(0, 360);
    design.case_options.inside_mm = Vec3d{90, 110, 100};
    design.case_options.division = Division::all;
    const int shape = random.integer(0, 2);
    if (shape == 1) design.case_options.corner_radius_mm = 30;
    if (shape == 2) design.case_options.base_mm = CrossSection{100, 90};
    if (shape == 2) design.case_options.lid_mm = 40;
    if (shape == 2) design.case_options.top_mm = CrossSection{104, 92};
    if (random.chance(0.4))
        for (const int axis : {0, 1, 2}) {
            design.cut.clearance_mm.lower[axis] = random.between(0, 3);
            design.cut.clearance_mm.upper[axis] = random.between(0, 3);
        }
    if (random.chance(0.3)) design.fit.notches = NotchOptions{20, 15, 12, {}, {}, {}};
    if (random.chance(0.3)) design.fit.least_rib_mm = random.between(3, 10);
    design = *checked(design);
    result.object = *prepare(bytes ? *read_mesh(*bytes, name) : *made, design);
    result.packing = *pack(result.object, design);
    return result;
}

TEST(MillTest, WhatIsTakenOfTheBlocksIsToldWithItsWidthAndVolume) {
    Lost all;
    double told_mm3 = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(14, 4)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto milled = random_milled_case(random);
        if (!milled || !milled->packing.foams) continue;
        MillOptions options;
        options.flute_mm = 200;
        options.cutter_mm = random.between(2, 7);
        const auto plans = mill_plans(milled->foams(), milled->milled(), options);
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        for (const MillPlan& plan : plans->plans) {
            const GcodeProgram program =
                test::read_gcode(grbl_program(plan.path, plan.field.size_mm(), options, {"", ""}, {}));
            // At places that have nothing to do with blocks or cells.
            const Lost lost =
                lost_of(carved(program, plan, options, random.between(0.3, 0.45)), plan, options);
            EXPECT_LE(lost.farthest_mm, plan.relief.widest_mm + 2e-3);
            EXPECT_EQ(plan.relief.widest_mm > 0, plan.relief.overcut_mm3 > 0);
            all.places += lost.places;
            all.mm3 += lost.mm3;
            told_mm3 += plan.relief.overcut_mm3;
        }
    }
    EXPECT_GT(all.places, 500);
    EXPECT_NEAR(told_mm3 / all.mm3, 1, 0.1);
}

/// Whether a place in the case lies within it and its play, from the case's own measures.
bool within_case(const CaseSpace& fitted, double x, double y, double z) {
    const CaseOptions& options = fitted.options;
    const Vec3d inside = *options.inside_mm, middle = fitted.free.centre();
    const double height = x - fitted.free.min.x + options.play_mm;
    // No lid's line: widest at the roof.
    const double share = std::clamp(height / inside.x, 0.0, 1.0);
    const CrossSection base = options.base_mm.value_or(CrossSection{inside.y, inside.z});
    const double half_y = (base.width + (inside.y - base.width) * share) / 2 - options.play_mm;
    const double half_z = (base.length + (inside.z - base.length) * share) / 2 - options.play_mm;
    const double radius = std::max(0.0, options.corner_radius_mm - options.play_mm);
    const double dy = std::abs(y - middle.y), dz = std::abs(z - middle.z), slack = 5e-3;
    if (dy > half_y + slack || dz > half_z + slack) return false;
    const double cy = dy - (half_y - radius), cz = dz - (half_z - radius);
    return cy <= 0 || cz <= 0 || std::hypot(cy, cz) <= radius + slack;
}

TEST(MillTest, WhatIsMilledGoesIntoItsCase) {
    int places = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(10, 4)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(1000 + seed);
        const auto milled = random_milled_case(random);
        if (!milled || !milled->packing.foams || milled->design.case_options.top_mm) continue;
        MillOptions options;
        options.flute_mm = 200;
        options.cutter_mm = random.between(2, 8);
        const auto plans = mill_plans(milled->foams(), milled->milled(), options);
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        const DesignSpace& space = milled->packing.space;
        for (const MillPlan& plan : plans->plans) {
            if (plan.outside) continue;
            const bool lower = plan.piece.half() == Half::lower;
            const auto carved_by = [&](const MillPlan& each, double cell) {
                return carved(
                    test::read_gcode(grbl_program(each.path, each.field.size_mm(), options, {"", ""}, {})),
                    each, options, cell);
            };
            const double cell = random.between(0.4, 0.5);
            const GcodeStock stock = carved_by(plan, cell);
            std::optional<GcodeStock> outer;
            for (const MillPlan& other : plans->plans)
                if (other.outside && other.piece.half() == plan.piece.half()) outer = carved_by(other, cell);
            const Vec2d size = plan.field.size_mm();
            for (int row = 0; row < stock.height().ny(); ++row)
                for (int column = 0; column < stock.height().nz(); ++column) {
                    const Vec2d at = stock.middle(row, column);
                    // What stands, from its own side of the space.
                    const double high = stock.height()(row, column);
                    const double low = outer ? plan.field.top_mm() - outer->at({at.x, size.y - at.y}) : 0;
                    if (high <= low + 1e-3) continue;
                    ++places;
                    const double y = lower ? space.face(1, space.blocks.y) - at.y : space.face(1, 0) + at.y;
                    const double z = space.face(2, 0) + at.x;
                    for (const double up : {low, high}) {
                        const double x = lower ? space.face(0, 0) + up : space.face(0, space.blocks.x) - up;
                        ASSERT_TRUE(within_case(*milled->packing.fitted_case, x, y, z))
                            << (lower ? "lower " : "lid ") << at.x << " " << at.y << " " << up;
                    }
                }
        }
    }
    EXPECT_GT(places, 10000);
}

TEST(MillTest, AStripAtTheEdgeThatIsNarrowerThanTheCutterIsClearedFromBesideTheStock) {
    test::Heights lower = test::filled(20, 20, 4);
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k)
            if (j == 0 || k == 19) lower(j, k) = 1;
    const test::PrintDesign design({{5, 20, 20}, {6, 2, 2}}, lower, test::filled(20, 20, 1));
    MillOptions options;
    options.pin_mm = 0;
    const auto plans = mill_plans(design.view(), {}, options);
    ASSERT_TRUE(plans) << snug::text(plans.error().message);
    const MillPlan& plan = plans->plans.front();
    const GcodeProgram program =
        test::read_gcode(grbl_program(plan.path, plan.field.size_mm(), options, {"", ""}, {}));
    expect_sound(program, plan, options);
    EXPECT_EQ(plan.relief.overcut_mm3, 0);
    const GcodeStock stock = carved(program, plan, options, 0.3);
    EXPECT_EQ(lost_of(stock, plan, options).places, 0);
    for (int row = 0; row < stock.height().ny(); ++row)
        for (int column = 0; column < stock.height().nz(); ++column)
            ASSERT_LE(stock.height()(row, column), height_of(plan.field, stock.middle(row, column)) + 1e-3);
}

TEST(MillTest, WhatIsLeftOutBesideMissingColumnsIsNoSlot) {
    test::PrintDesign design({{5, 20, 20}, {6, 2, 2}}, test::filled(20, 20, 3), test::filled(20, 20, 2));
    Grid<snug::Run> available = all_blocks(design.space.blocks);
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k) {
            const int in = std::min({j, k, 19 - j, 19 - k});
            if (in < 2) available(j, k) = {};       // not there at all
            if (in == 2) available(j, k) = {1, 5};  // 2 mm beside the air
        }
    design.shorten(std::move(available));
    MillOptions options;
    options.pin_mm = 0;
    const auto plans = mill_plans(design.view(), {}, options);
    ASSERT_TRUE(plans) << snug::text(plans.error().message);
    ASSERT_EQ(plans->plans.size(), 3u);
    EXPECT_EQ(plans->plans[2].relief.overcut_mm3, 0);
    EXPECT_TRUE(plans->plans[2].relief.reliefs.empty());
}

TEST(MillTest, TheCarvedStockRebuildsRandomHeightFieldsAndNothingStaysInCorners) {
    for (int seed = 0; seed < test::cases(40); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const DesignSpace space{
            {random.integer(2, 6), random.integer(2, 8), random.integer(2, 8)},
            {random.between(3, 12), random.integer(14, 24) * 0.5, random.integer(14, 24) * 0.5}};
        const test::PrintDesign design(space, test::random_heights(random, space.blocks),
                                       test::random_heights(random, space.blocks));
        MillOptions options;
        options.cutter_mm = random.between(1.5, 3.2);
        options.flute_mm = 200;
        options.stepover = random.between(0.2, 0.9);
        options.pin_mm = random.chance(0.5) ? 4 : 0;
        if (random.chance(0.5)) options.step_down_mm = random.between(0.7, 6);
        options.origin = random.chance(0.5) ? MillOrigin::centre : MillOrigin::corner;
        const auto plans = mill_plans(design.view(), {}, options);
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        MillOptions corner = options;
        corner.origin = MillOrigin::corner;
        const auto pack = mill_pack(design.view(), {}, corner);
        ASSERT_TRUE(pack);
        for (const MillPlan& plan : plans->plans) {
            const std::string text =
                text_of(*pack, plan.piece.half() == Half::lower ? "mill/lower.nc" : "mill/lid.nc");
            const double steps = plan.field.steps_a_block;
            EXPECT_NEAR(steps * plan.field.step_mm, space.block_mm.x, 1e-9);
            EXPECT_LE(plan.field.step_mm, options.step_down_mm.value_or(options.cutter_mm / 2) + 1e-9);
            if (plan.empty()) {
                EXPECT_TRUE(text.empty());
                EXPECT_EQ(plan.field.lowest(), plan.field.top);
                continue;
            }
            const GcodeProgram program = test::read_gcode(text);
            expect_sound(program, plan, corner);
            const GcodeStock stock = carved(program, plan, corner, 0.25);
            expect_the_blocks(stock, plan, design.view());
            expect_no_more_lost_than_told(stock, plan, corner);
            // Without an object nothing may stay in the blocks that are cut.
            for (int row = 0; row < stock.height().ny(); ++row)
                for (int column = 0; column < stock.height().nz(); ++column)
                    ASSERT_LE(stock.height()(row, column),
                              height_of(plan.field, stock.middle(row, column)) + 1e-3);
        }
    }
}

TEST(MillTest, OfSeveralItemsFoamStandsWhereEachOfThemAllowsIt) {
    Design design;
    design.object.units = Unit::mm;
    design.object.longest_mm = 90;
    apply(*find_preset(built_in_presets(), "mill"), design);
    design.space.blocks.reset();
    std::vector<Object> objects;
    for (const char* name : {"vase", "camera"}) objects.push_back(prepare(*sample(name), design).value());
    design.items = {{}, {}};
    design.items[1].object = 1;
    design.items[1].clearance_mm = Clearance{{0.5, 1, 2}, {2, 0, 1}};
    const Packing packing = pack(objects, checked(design).value()).value();
    ASSERT_TRUE(packing.foams);
    const FoamDesign foams{packing.space, packing.layers, *packing.foams, packing.available, "kit"};
    const auto surface = [&](std::size_t i) {
        const Item& item = packing.items[i];
        return MilledSurface{objects[item.object].mesh, item.placement, item.cut};
    };
    for (const Half half : {Half::lower, Half::lid}) {
        const MillField field = mill_field(foams, half, 3);
        const CarvedStock stock(field, 3, 1);
        const auto allowed = [&](std::vector<MilledSurface> surfaces) {
            return allowed_heights(foams, half, field, stock, MilledObject{std::move(surfaces)});
        };
        const Grid<int> both = allowed({surface(0), surface(1)}), one = allowed({surface(0)}),
                        other = allowed({surface(1)});
        long long lowered = 0;
        for (std::size_t cell = 0; cell < both.size(); ++cell) {
            ASSERT_EQ(both[cell], std::min(one[cell], other[cell]));
            lowered += one[cell] != other[cell];
        }
        EXPECT_GT(lowered, 1000);
    }
}

}  // namespace
}  // namespace snug
