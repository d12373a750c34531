#include "tests/support/milled.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <gtest/gtest.h>

#include "snug/design/presets.h"
#include "snug/fabricate/mill/gcode.h"
#include "snug/words/words.h"

#include "tests/support/heights.h"

namespace snug::test {
namespace {

bool in_a_pin(const MillPlan& plan, Vec2d at, double radius) {
    return std::any_of(plan.pins.begin(), plan.pins.end(),
                       [&](const MillPin& pin) { return length(pin.at - at) <= radius; });
}

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
            least = std::min(
                least, length(Vec2d{away(at.x, column, field.cell_mm.x), away(at.y, row, field.cell_mm.y)}));
        }
    return least;
}

/// No foam within the clearance of any point of the object, by brute force.
void expect_clear(const GcodeStock& stock, const MillPlan& plan, const Object& object, const Packing& packing,
                  const Design& design, Random& random) {
    const Vec3d e = plan.piece.half() == Half::lower ? design.cut.whole_clearance_mm().lower
                                                     : design.cut.whole_clearance_mm().upper;
    const DesignSpace& space = packing.space;
    const double around = e.y - 0.011;
    const auto check = [&](Vec3d p) {
        const double up =
            plan.piece.half() == Half::lower ? p.x - space.face(0, 0) : space.face(0, space.blocks.x) - p.x;
        const Vec2d at{p.z - space.face(2, 0), plan.piece.half() == Half::lower
                                                   ? space.face(1, space.blocks.y) - p.y
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
        const Vec3d a = packing.items.front().placement(object.mesh.vertices[t[0]]);
        const Vec3d b = packing.items.front().placement(object.mesh.vertices[t[1]]);
        const Vec3d c = packing.items.front().placement(object.mesh.vertices[t[2]]);
        check(a);
        check(a + (b - a) * u + (c - a) * v);
    }
}

}  // namespace

double height_of(const MillField& field, Vec2d at) {
    const int row = std::clamp(static_cast<int>(at.y / field.cell_mm.y), 0, field.height.ny() - 1);
    const int column = std::clamp(static_cast<int>(at.x / field.cell_mm.x), 0, field.height.nz() - 1);
    return field.height(row, column) * field.step_mm;
}

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

void expect_the_blocks(const GcodeStock& stock, const MillPlan& plan, const FoamDesign& design) {
    const bool lid = plan.piece.half() == Half::lid;
    const Heights kept = heights_of(design.foams, plan.piece.half(), design.space.blocks.x);
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

MilledCase milled_case(Mesh mesh, double longest_mm, double wall_mm) {
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
            read_gcode(grbl_program(plan.path, plan.field.size_mm(), options, {"vase", ""}, {}));
        expect_sound(program, plan, options);
        const GcodeStock stock = carved(program, plan, options, 0.5);
        expect_clear(stock, plan, milled.object, milled.packing, milled.design, random);
        expect_no_more_lost_than_told(stock, plan, options);
    }
}

}  // namespace snug::test
