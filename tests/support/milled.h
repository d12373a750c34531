#pragma once

#include <string>

#include "snug/fabricate/mill/mill.h"
#include "snug/fabricate/mill/mill_plan.h"
#include "snug/make.h"

#include "tests/support/gcode_stock.h"
#include "tests/support/pack_file.h"
#include "tests/support/random.h"

// What a mill's program leaves of its stock, against the foam and the object that it was made for.

namespace snug::test {

/// What the machine does is what GRBL allows: no rapid move through foam, no sloping one, none too deep.
void expect_sound(const GcodeProgram& program, const MillPlan& plan, const MillOptions& options);

[[nodiscard]] GcodeStock carved(const GcodeProgram& program, const MillPlan& plan, const MillOptions& options,
                                double cell);

/// Of the blocks, at a place of the field.
[[nodiscard]] double height_of(const MillField& field, Vec2d at);

/// Foam that the blocks keep is lost only beside a wall, as far as was told, and in the pins' holes.
void expect_no_more_lost_than_told(const GcodeStock& stock, const MillPlan& plan, const MillOptions& options);

/// Foam of the blocks that the program takes, measured at many arbitrary places.
struct Lost {
    int places = 0;
    double mm3 = 0;
    double farthest_mm = 0;  ///< from where the blocks are cut as deep
};

[[nodiscard]] Lost lost_of(const GcodeStock& stock, const MillPlan& plan, const MillOptions& options);

/// The block map at the middles of columns that are wider than the cutter.
void expect_the_blocks(const GcodeStock& stock, const MillPlan& plan, const FoamDesign& design);

struct MilledCase {
    Design design;
    Object object;
    Packing packing;
    [[nodiscard]] FoamDesign foams() const {
        return {packing.space, packing.layers, *packing.foams, packing.available, "vase"};
    }
    [[nodiscard]] MilledObject milled() const {
        return {{{object.mesh, packing.items.front().placement, design.cut}},
                packing.fitted_case ? &*packing.fitted_case : nullptr};
    }
};

/// In a fitted space of the mill's preset, turned.
[[nodiscard]] MilledCase milled_case(Mesh mesh, double longest_mm, double wall_mm);

/// Every program of the case: sound, clear of the object by brute force, and with no more lost than was told.
void expect_milled(const MilledCase& milled, const MillOptions& options, Random& random);

}  // namespace snug::test
