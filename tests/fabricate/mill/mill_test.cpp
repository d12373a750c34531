#include "snug/fabricate/mill/mill.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/design/presets.h"
#include "snug/fabricate/mill/gcode.h"
#include "snug/fabricate/mill/mill_plan.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/gcode_stock.h"
#include "tests/support/models.h"
#include "tests/support/print_design.h"

namespace snug {
namespace {

using test::GcodeMove;
using test::GcodeProgram;
using test::GcodeStock;
using test::Random;

std::string text_of(const WorkshopPack& pack, const std::string& name) {
    for (const PackFile& file : pack.files)
        if (file.name == name) return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
    return {};
}

/// No byte that GRBL or what sends to it takes for anything but text, and lines that it has room for.
void expect_harmless(const std::string& text) {
    for (const char c : text) {
        const bool printable = c >= 32 && c < 127;
        ASSERT_TRUE(c == '\n' ||
                    (printable && std::string("!~?%;$\\\"[]{}<>^`|*#@").find(c) == std::string::npos))
            << static_cast<int>(c);
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        ASSERT_LT(line.size(), 80u) << line;
        const auto brackets =
            std::count_if(line.begin(), line.end(), [](char c) { return c == '(' || c == ')'; });
        ASSERT_TRUE(brackets == 0 || (brackets == 2 && line.front() == '(' && line.back() == ')')) << line;
    }
}

/// What the machine does is what GRBL allows: no rapid move through foam, no sloping one, none too deep.
void expect_sound(const GcodeProgram& program, const MillPlan& plan, const MillOptions& options) {
    for (const std::string& problem : program.problems) ADD_FAILURE() << problem;
    EXPECT_TRUE(program.ended);
    const Vec2d size = plan.field.size_mm();
    for (const GcodeMove& move : program.moves) {
        const bool sideways = move.from.x != move.to.x || move.from.y != move.to.y;
        if (move.rapid) {
            if (sideways) {
                ASSERT_NEAR(move.from.z, options.safe_mm, 1e-9);
                ASSERT_NEAR(move.to.z, options.safe_mm, 1e-9);
            }
            ASSERT_GE(move.to.z, move.from.z) << "plunges at a rapid";
            continue;
        }
        ASSERT_TRUE(!sideways || move.from.z == move.to.z) << "slopes";
        ASSERT_GE(move.to.z, -options.flute_mm - 1e-3);
        ASSERT_GE(move.to.z, -plan.field.top_mm() - 1e-3);
        for (const Vec3d at : {move.from, move.to}) {
            ASSERT_GE(std::min(at.x, at.y), -1e-3 - options.cutter_mm / 2);
            ASSERT_LE(at.x, size.x + 1e-3 + options.cutter_mm / 2);
            ASSERT_LE(at.y, size.y + 1e-3 + options.cutter_mm / 2);
        }
        if (move.to.z < move.from.z && move.from.z <= 1e-9) {
            ASSERT_LE(move.feed, std::max(options.plunge_mm_min, options.feed_mm_min));
        }
    }
}

GcodeStock carved(const GcodeProgram& program, const MillPlan& plan, const MillOptions& options,
                  double cell) {
    const Vec2d size = plan.field.size_mm();
    GcodeStock stock({size.x, size.y, plan.field.top_mm()}, cell);
    for (const GcodeMove& move : program.moves)
        if (!move.rapid) stock.cut(move, options.cutter_mm / 2);
    return stock;
}

bool in_a_pin(const MillPlan& plan, Vec2d at, double radius) {
    return std::any_of(plan.pins.begin(), plan.pins.end(),
                       [&](const MillPin& pin) { return length(pin.at - at) <= radius; });
}

double height_of(const MillField& field, Vec2d at) {
    const int row = std::clamp(static_cast<int>(at.y / field.cell_mm.y), 0, field.height.ny() - 1);
    const int column = std::clamp(static_cast<int>(at.x / field.cell_mm.x), 0, field.height.nz() - 1);
    return field.height(row, column) * field.step_mm;
}

/// Foam that the blocks keep is lost only beside a wall, as far as was told, and in the pins' holes.
void expect_no_more_lost_than_told(const GcodeStock& stock, const MillPlan& plan,
                                   const MillOptions& options) {
    const double reach = plan.relief.widest_mm + 0.02;
    const int cells = static_cast<int>(reach / stock.cell()) + 2;
    int lost = 0;
    for (int row = 0; row < stock.height().ny(); ++row)
        for (int column = 0; column < stock.height().nz(); ++column) {
            const Vec2d at = stock.middle(row, column);
            const double height = stock.height()(row, column);
            if (height >= height_of(plan.field, at) - 1e-3) continue;
            if (in_a_pin(plan, at, options.pin_mm / 2 + 0.01)) continue;
            ++lost;
            bool beside = false;
            for (int r = row - cells; r <= row + cells && !beside; ++r)
                for (int c = column - cells; c <= column + cells && !beside; ++c) {
                    if (!stock.height().contains(r, c)) continue;
                    const Vec2d other = stock.middle(r, c);
                    beside = length(other - at) <= reach + 1.5 * stock.cell() &&
                             height_of(plan.field, other) <= height + 1e-3;
                }
            ASSERT_TRUE(beside) << at.x << " " << at.y << " " << height;
        }
    if (plan.relief.reliefs.empty()) {
        EXPECT_EQ(lost, 0);
    }
}

/// Foam of the blocks that the program takes, measured at many arbitrary places.
struct Lost {
    int places = 0;
    double mm3 = 0;
    double farthest_mm = 0;  ///< from where the blocks are cut as deep
};

double away_from_pocket(const MillField& field, Vec2d at, double height, double reach) {
    double least = reach;
    const auto index = [](double mm, double cell) { return static_cast<int>(std::floor(mm / cell)); };
    for (int row = index(at.y - reach, field.cell_mm.y); row <= index(at.y + reach, field.cell_mm.y); ++row)
        for (int column = index(at.x - reach, field.cell_mm.x);
             column <= index(at.x + reach, field.cell_mm.x); ++column) {
            if (!field.height.contains(row, column) ||
                field.height(row, column) * field.step_mm > height + 1e-3)
                continue;
            const auto away = [](double value, int cell, double mm) {
                return std::max({cell * mm - value, value - (cell + 1) * mm, 0.0});
            };
            least = std::min(least,
                             length({away(at.x, column, field.cell_mm.x), away(at.y, row, field.cell_mm.y)}));
        }
    return least;
}

Lost lost_of(const GcodeStock& stock, const MillPlan& plan, const MillOptions& options) {
    Lost lost;
    for (int row = 0; row < stock.height().ny(); ++row)
        for (int column = 0; column < stock.height().nz(); ++column) {
            const Vec2d at = stock.middle(row, column);
            const double height = stock.height()(row, column), wanted = height_of(plan.field, at);
            if (height >= wanted - 1e-3 || in_a_pin(plan, at, options.pin_mm / 2 + 0.01)) continue;
            ++lost.places;
            lost.mm3 += (wanted - height) * stock.cell() * stock.cell();
            lost.farthest_mm =
                std::max(lost.farthest_mm, away_from_pocket(plan.field, at, height, 3 * options.cutter_mm));
        }
    return lost;
}

/// The block map at the middles of columns that are wider than the cutter.
void expect_the_blocks(const GcodeStock& stock, const MillPlan& plan, const FoamDesign& design) {
    const bool lid = plan.half == Half::lid;
    const Grid<std::uint16_t>& kept = lid ? design.foams.upper : design.foams.lower;
    const Vec3d block = design.space.block_mm;
    for (int j = 0; j < kept.ny(); ++j)
        for (int k = 0; k < kept.nz(); ++k) {
            // BACK (j = 0) is far in the lower half and near in the lid; k runs to the right.
            const double y = lid ? (j + 0.5) * block.y : (kept.ny() - j - 0.5) * block.y;
            const Vec2d at{(k + 0.5) * block.z, y};
            if (in_a_pin(plan, at, block.y)) continue;
            EXPECT_NEAR(stock.at(at), kept(j, k) * block.x, 1e-3) << j << " " << k;
        }
}

/// No foam within the clearance of any point of the object, by brute force.
void expect_clear(const GcodeStock& stock, const MillPlan& plan, const Object& object, const Packing& packing,
                  const Design& design, Random& random) {
    const Vec3d e = plan.half == Half::lower ? design.cut.whole_clearance_mm().lower
                                             : design.cut.whole_clearance_mm().upper;
    const DesignSpace& space = packing.space;
    const double around = e.y - 0.011;
    const auto check = [&](Vec3d p) {
        const double up =
            plan.half == Half::lower ? p.x - space.face(0, 0) : space.face(0, space.blocks.x) - p.x;
        const Vec2d at{p.z - space.face(2, 0), plan.half == Half::lower ? space.face(1, space.blocks.y) - p.y
                                                                        : p.y - space.face(1, 0)};
        for (double dx : {-around, 0.0, around})
            for (double dy : {-around, 0.0, around})
                ASSERT_LE(stock.at(at + Vec2d{dx, dy}), up - e.x + 0.011 + 1e-4) << at.x << " " << at.y;
    };
    const auto& triangles = object.mesh.triangles;
    for (std::size_t i = 0; i < triangles.size(); i += 1 + triangles.size() / 60000) {
        const Triangle& t = triangles[i];
        double u = random.unit(), v = random.unit();
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const Vec3d a = packing.placement(object.mesh.vertices[t[0]]);
        const Vec3d b = packing.placement(object.mesh.vertices[t[1]]);
        const Vec3d c = packing.placement(object.mesh.vertices[t[2]]);
        check(a);
        check(a + (b - a) * u + (c - a) * v);
    }
}

struct MilledCase {
    Design design;
    Object object;
    Packing packing;
    [[nodiscard]] FoamDesign foams() const { return {packing.space, packing.blocks, *packing.foams, "vase"}; }
    [[nodiscard]] MilledObject milled() const {
        return {object.mesh, packing.placement, design.cut,
                packing.fitted_case ? &*packing.fitted_case : nullptr};
    }
};

MilledCase packed(Mesh mesh, double longest_mm, double wall_mm) {
    MilledCase result;
    Design& design = result.design;
    apply(*find_preset(built_in_presets(), "mill"), design);
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(wall_mm);
    design.object.longest_mm = longest_mm;
    design.placement.rotation_deg = {20, 30, 10};
    design = *checked(design);
    result.object = *prepare(std::move(mesh), design);
    result.packing = *pack(result.object, design);
    return result;
}

void expect_milled(const MilledCase& milled, const MillOptions& options, Random& random) {
    ASSERT_TRUE(milled.packing.foams);
    const auto plans = mill_plans(milled.foams(), milled.milled(), options);
    ASSERT_TRUE(plans) << snug::text(plans.error().message);
    for (const MillPlan& plan : plans->plans) {
        const GcodeProgram program =
            test::read_gcode(grbl_program(plan.path, plan.field.size_mm(), options, {"vase", ""}, {}));
        expect_sound(program, plan, options);
        const GcodeStock stock = carved(program, plan, options, 0.5);
        expect_clear(stock, plan, milled.object, milled.packing, milled.design, random);
        expect_no_more_lost_than_told(stock, plan, options);
    }
}

int cases(int most) {
    const char* text = std::getenv("SNUG_CASES");
    return text ? std::min(most, std::max(4, std::atoi(text) / 20)) : most;
}

TEST(MillTest, NoFoamIsLeftWhereTheSamplesAreAndNoMoreIsLostThanTold) {
    Random random(1);
    for (const char* name : {"torus", "vase", "figurine", "camera"}) {
        SCOPED_TRACE(name);
        expect_milled(packed(*sample(name), 70, 12), {}, random);
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
        expect_milled(packed(*read_mesh(*bytes, name), 60, 12), options, random);
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
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(cases(14)); ++seed) {
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
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(cases(10)); ++seed) {
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
            const bool lower = plan.half == Half::lower;
            const auto carved_by = [&](const MillPlan& each, double cell) {
                return carved(
                    test::read_gcode(grbl_program(each.path, each.field.size_mm(), options, {"", ""}, {})),
                    each, options, cell);
            };
            const double cell = random.between(0.4, 0.5);
            const GcodeStock stock = carved_by(plan, cell);
            std::optional<GcodeStock> outer;
            for (const MillPlan& other : plans->plans)
                if (other.outside && other.half == plan.half) outer = carved_by(other, cell);
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
    design.foams.available = {20, 20, {0, 5}};
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k) {
            const int in = std::min({j, k, 19 - j, 19 - k});
            if (in < 2) design.foams.lower(j, k) = design.foams.upper(j, k) = 0;
            if (in < 2) design.foams.available(j, k) = {};       // not there at all
            if (in == 2) design.foams.available(j, k) = {1, 5};  // 2 mm beside the air
        }
    MillOptions options;
    options.pin_mm = 0;
    const auto plans = mill_plans(design.view(), {}, options);
    ASSERT_TRUE(plans) << snug::text(plans.error().message);
    ASSERT_EQ(plans->plans.size(), 3u);
    EXPECT_EQ(plans->plans[2].relief.overcut_mm3, 0);
    EXPECT_TRUE(plans->plans[2].relief.reliefs.empty());
}

TEST(MillTest, TheCarvedStockRebuildsRandomHeightFieldsAndNothingStaysInCorners) {
    for (int seed = 0; seed < cases(40); ++seed) {
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
                text_of(*pack, plan.half == Half::lower ? "mill/lower.nc" : "mill/lid.nc");
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

/// The board's holes are where the half has its own once it is turned over about x.
void expect_board_takes(const std::string& board_program, const MillPlan& half, Vec2d zero = {}) {
    const GcodeProgram board = test::read_gcode(board_program);
    for (const std::string& problem : board.problems) ADD_FAILURE() << problem;
    ASSERT_EQ(half.pins.size(), 2u);
    for (const MillPin& pin : half.pins)
        EXPECT_TRUE(std::any_of(board.moves.begin(), board.moves.end(), [&](const GcodeMove& move) {
            return !move.rapid && std::abs(move.to.x + zero.x - pin.at.x) < 1e-3 &&
                   std::abs(move.to.y + zero.y - (half.field.size_mm().y - pin.at.y)) < 1e-3;
        }));
}

TEST(MillTest, WhatACaseLeavesOutIsMilledFromOutsideOnTheSamePins) {
    test::PrintDesign design({{4, 8, 10}, {10, 10, 10}}, test::filled(8, 10, 2), test::filled(8, 10, 2));
    design.foams.lower(4, 4) = 1;
    design.blocks(4, 4) = {1, 2};
    design.foams.available = {8, 10, {0, 4}};
    design.foams.available(0, 0).first = 1;  // BACK, left
    MillOptions options;
    options.pin_mm = 6;
    const auto plans = mill_plans(design.view(), {}, options);
    ASSERT_TRUE(plans) << snug::text(plans.error().message);
    ASSERT_EQ(plans->plans.size(), 3u);
    const MillPlan& outside = plans->plans[2];
    EXPECT_EQ(outside.half, Half::lower);
    // BACK is far in the lower half; turned over about x it comes near, and left stays left.
    EXPECT_EQ(outside.field.height(0, 0), outside.field.top - outside.field.steps_a_block);
    EXPECT_EQ(std::count(outside.field.height.begin(), outside.field.height.end(), outside.field.top), 79);
    const auto pack = mill_pack(design.view(), {}, options);
    ASSERT_TRUE(pack);
    EXPECT_FALSE(text_of(*pack, "mill/lower-outside.nc").empty());
    EXPECT_TRUE(text_of(*pack, "mill/lid-outside.nc").empty());
    EXPECT_TRUE(text_of(*pack, "mill/lid-board.nc").empty());
    expect_board_takes(text_of(*pack, "mill/lower-board.nc"), plans->plans[0]);
}

TEST(MillTest, EachTurnedHalfLiesOnItsOwnHolesInTheBoard) {
    test::PrintDesign design({{4, 8, 10}, {10, 10, 10}}, test::filled(8, 10, 2), test::filled(8, 10, 2));
    design.foams.available = {8, 10, {0, 4}};
    design.foams.available(0, 0) = {1, 3};
    for (const MillOrigin origin : {MillOrigin::corner, MillOrigin::centre}) {
        MillOptions options;
        options.origin = origin;
        const auto plans = mill_plans(design.view(), {}, options);
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        const auto pack = mill_pack(design.view(), {}, options);
        ASSERT_TRUE(pack);
        const Vec2d zero = origin == MillOrigin::centre ? Vec2d{50, 40} : Vec2d{};
        expect_board_takes(text_of(*pack, "mill/lower-board.nc"), plans->plans[0], zero);
        expect_board_takes(text_of(*pack, "mill/lid-board.nc"), plans->plans[1], zero);
    }
}

TEST(MillTest, EveryProgramSaysWhichSideIsUpWhereBackIsAndWhereZeroIs) {
    test::PrintDesign design({{4, 8, 10}, {10, 10, 10}}, test::filled(8, 10, 2), test::filled(8, 10, 2));
    design.foams.lower(4, 4) = design.foams.upper(4, 4) = 1;
    design.blocks(4, 4) = {1, 3};
    design.foams.available = {8, 10, {0, 4}};
    design.foams.available(0, 0) = {1, 3};
    const auto pack = mill_pack(design.view(), {}, {});
    ASSERT_TRUE(pack);
    struct Said {
        const char *file, *up, *back, *zero;
    };
    const char* const corner = "(X0 Y0 at the near left corner of the stock, Z0 on its top)";
    const char* const board = "(X0 Y0 at the near left corner of where the stock will lie, Z0 on the board)";
    const std::vector<Said> all{
        {"lower.nc", "(LOWER, cavity up. Object: L & co)", "(BACK away from you)", corner},
        {"lid.nc", "(LID, cavity up. Object: L & co)", "(BACK towards you)", corner},
        {"lower-outside.nc", "(LOWER, outer side up, cavity down. Object: L & co)", "(BACK towards you)",
         corner},
        {"lid-outside.nc", "(LID, outer side up, cavity down. Object: L & co)", "(BACK away from you)",
         corner},
        {"lower-board.nc", "(BOARD below LOWER. Object: L & co)", "cavity down, BACK towards you)", board},
        {"lid-board.nc", "(BOARD below LID. Object: L & co)", "cavity down, BACK away from you)", board}};
    EXPECT_EQ(pack->files.size(), all.size());
    for (const Said& said : all) {
        std::string text = text_of(*pack, std::string("mill/") + said.file);
        expect_harmless(text);
        // Long remarks go on in the next comment.
        for (std::size_t at; (at = text.find(")\n(")) != std::string::npos;) text.replace(at, 3, " ");
        text = text.substr(0, text.find('\n'));
        for (const char* words : {said.up, said.back, said.zero}) {
            std::string bare = words;
            bare.erase(std::remove_if(bare.begin(), bare.end(), [](char c) { return c == '(' || c == ')'; }),
                       bare.end());
            EXPECT_NE(text.find(bare), std::string::npos) << said.file << ": " << bare << " in " << text;
        }
        EXPECT_EQ(text.find("cavity up") == std::string::npos,
                  std::string(said.file).find('-') != std::string::npos)
            << text;
    }
}

TEST(MillTest, PinsFitOneWayAndMeetInBothHalves) {
    Random random(4);
    int with_pins = 0;
    for (int i = 0; i < 30; ++i) {
        const DesignSpace space{{4, random.integer(5, 12), random.integer(5, 12)}, {12, 10, 10}};
        test::Heights lower = test::filled(space.blocks.y, space.blocks.z, 2), upper = lower;
        for (int n = 0; n < 4; ++n) {
            lower(random.integer(1, space.blocks.y - 2), random.integer(1, space.blocks.z - 2)) = 0;
            upper(random.integer(0, space.blocks.y - 1), random.integer(0, space.blocks.z - 1)) = 1;
        }
        const test::PrintDesign design(space, lower, upper);
        const auto plans = mill_plans(design.view(), {}, {});
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        const auto &own = plans->plans[0].pins, &other = plans->plans[1].pins;
        ASSERT_EQ(own.size(), other.size());
        if (own.empty()) continue;
        ++with_pins;
        const Vec2d size = plans->plans[0].field.size_mm();
        for (std::size_t pin = 0; pin < own.size(); ++pin) {
            EXPECT_NEAR(own[pin].at.x, other[pin].at.x, 1e-9);
            EXPECT_NEAR(own[pin].at.y, size.y - other[pin].at.y, 1e-9);
            for (const double dx : {-6.0, 0.0, 6.0})
                for (const double dy : {-6.0, 0.0, 6.0}) {
                    EXPECT_EQ(height_of(plans->plans[0].field, own[pin].at + Vec2d{dx, dy}), 24);
                    EXPECT_EQ(height_of(plans->plans[1].field, other[pin].at + Vec2d{dx, dy}), 24);
                }
        }
        const Vec2d turned = size - own[0].at;
        EXPECT_GE(length(turned - own[1].at), 9);
    }
    EXPECT_GT(with_pins, 15);
}

TEST(MillTest, WhatTheCutterCannotDoIsSaidWithWhatWouldWork) {
    test::Heights lower = test::filled(9, 9, 3);
    lower(4, 4) = 0;
    const test::PrintDesign design({{4, 9, 9}, {10, 10, 10}}, lower, test::filled(9, 9, 1));
    MillOptions options;
    options.cutter_mm = 12;
    auto refused = mill_pack(design.view(), {}, options);
    ASSERT_FALSE(refused);
    EXPECT_NE(snug::text(refused.error().message).find("10 mm"), std::string::npos)
        << snug::text(refused.error().message);
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
    options.cutter_mm = 10;
    options.flute_mm = 29;
    refused = mill_pack(design.view(), {}, options);
    ASSERT_FALSE(refused);
    EXPECT_NE(snug::text(refused.error().message).find("at least 30 mm"), std::string::npos)
        << snug::text(refused.error().message);
    options.flute_mm = 30;
    EXPECT_TRUE(mill_pack(design.view(), {}, options));
    options.feed_mm_min = 0;
    EXPECT_FALSE(mill_pack(design.view(), {}, options));
}

TEST(MillTest, FlatHalvesNeedNoProgram) {
    const test::PrintDesign design({{4, 9, 9}, {10, 10, 10}}, test::filled(9, 9, 2), test::filled(9, 9, 2));
    MillOptions options;
    options.pin_mm = 0;
    const auto pack = mill_pack(design.view(), {}, options);
    ASSERT_TRUE(pack);
    EXPECT_TRUE(pack->files.empty());
    EXPECT_EQ(pack->findings.front().code(), "nothing_to_mill");
}

/// Names of any bytes, most of them of those that do harm.
std::string hostile_name(Random& random) {
    static const std::vector<std::string> parts{"!",
                                                "~",
                                                "?",
                                                "%",
                                                ";",
                                                "(",
                                                ")",
                                                "$X",
                                                "\n",
                                                "\r",
                                                "\t",
                                                "\x18",
                                                "\x7f",
                                                "\x84",
                                                "\x85",
                                                "\xff",
                                                "\xe5\xa3\xba",
                                                "\xc3\xa4",
                                                "\xf0\x9f\x8f\xba",
                                                "\xe2\x80\xa8",
                                                "M3 S9",
                                                "G0 Z-50",
                                                " ",
                                                "vase",
                                                "L",
                                                "\xc3",
                                                "\xcc\x88",
                                                "*",
                                                "[",
                                                "/"};
    std::string name;
    for (int i = random.integer(0, 60); i > 0; --i)
        name += random.chance(0.8)
                    ? parts[static_cast<std::size_t>(random.integer(0, static_cast<int>(parts.size()) - 1))]
                    : std::string(1, static_cast<char>(random.integer(0, 255)));
    return name;
}

TEST(MillTest, NoNameStopsOrStartsTheMachine) {
    Random random(17);
    for (int i = 0; i < 3000; ++i) {
        const std::string name = hostile_name(random);
        SCOPED_TRACE("case " + std::to_string(i));
        const std::string text =
            grbl_program({}, {10, 10}, {}, {"LID, outer side up, cavity down", name}, {name, "BACK " + name});
        expect_harmless(text);
        EXPECT_EQ(text.rfind("(LID, outer side up, cavity down", 0), 0u) << text;
        const GcodeProgram program = test::read_gcode(text);
        EXPECT_TRUE(program.problems.empty());
        EXPECT_TRUE(program.moves.empty());
        EXPECT_TRUE(program.ended);
    }
}

TEST(MillTest, ALongNameIsShortenedAndTheWordsAreNot) {
    const auto first_line = [](const std::string& name) {
        const std::string text = grbl_program({}, {10, 10}, {}, {"LOWER, cavity up", name}, {});
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(first_line("fragile! ~ keep"), "(LOWER, cavity up. Object: fragile keep)");
    EXPECT_EQ(first_line("M\xc3\xbcller \xe5\xa3\xba\xe5\xa3\xba 2"),
              "(LOWER, cavity up. Object: Muller _ 2)");
    EXPECT_EQ(first_line("!?"), "(LOWER, cavity up)");
    const std::string line = first_line(std::string(500, 'x'));
    EXPECT_EQ(line.size(), 72u);
    EXPECT_EQ(line.substr(0, 30), "(LOWER, cavity up. Object: xxx");
    EXPECT_EQ(line.substr(68), "...)");
}

}  // namespace
}  // namespace snug
