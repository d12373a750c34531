#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "snug/check/gap.h"

#include "tests/support/gap_cases.h"
#include "tests/support/random_gap.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::cut_cube;
using test::kAsItIs;
using test::report;
using test::small_space;

void expect_halves_add_up(const GapReport& r, const DesignSpace& space) {
    EXPECT_NEAR(r.lower.step_mm3 + r.upper.step_mm3, r.step_mm3, 1e-6 * r.cut_mm3 + 1e-9);
    ASSERT_EQ(r.lower.undercut_mm3.has_value(), r.undercut_mm3.has_value());
    if (r.undercut_mm3) {
        EXPECT_NEAR(*r.lower.undercut_mm3 + *r.upper.undercut_mm3, *r.undercut_mm3, 1e-6 * r.cut_mm3 + 1e-9);
    }
    for (const HalfGap* half : {&r.lower, &r.upper})
        EXPECT_LE(half->widest_mm, r.widest_mm + r.widest_error_mm + 1e-9);
    double lower = 0, upper = 0;
    const double area = space.block_mm.y * space.block_mm.z;
    for (const ColumnGap& column : r.columns) {
        lower += (column.lower_step + column.lower_undercut) * area;
        upper += (column.upper_step + column.upper_undercut) * area;
    }
    EXPECT_NEAR(lower, r.lower.step_mm3 + r.lower.undercut_mm3.value_or(0), 1e-5 * r.cut_mm3 + 1e-9);
    EXPECT_NEAR(upper, r.upper.step_mm3 + r.upper.undercut_mm3.value_or(0), 1e-5 * r.cut_mm3 + 1e-9);
}

TEST(GapOfHalves, WhatLiesOverABoxIsTheLidsAndWhatLiesUnderItTheLowerFoams) {
    const DesignSpace space = small_space();
    const GapReport above = report(test::box_mesh({-30, -30, -30}, {18, 30, 30}), space, cut_cube(space));
    expect_halves_add_up(above, space);
    EXPECT_NEAR(above.upper.step_mm3, 12 * 60 * 60, 1e-3);
    EXPECT_NEAR(above.lower.step_mm3, 0, 1e-3);
    EXPECT_NEAR(above.upper.widest_mm, 12, 0.25);
    EXPECT_LT(above.lower.widest_mm, 0.3);
    // Over a low object the gap below its top is still the lid's, wherever the halves part.
    const GapReport low = report(test::box_mesh({-30, -30, -30}, {-18, 30, 30}), space, cut_cube(space));
    EXPECT_NEAR(low.upper.step_mm3, 48 * 60 * 60, 1e-3);
    EXPECT_NEAR(low.lower.step_mm3, 0, 1e-3);
}

TEST(GapOfHalves, WhatLiesUnderAMushroomsCapIsTheLowerFoams) {
    const DesignSpace space = small_space();
    Mesh mushroom = test::box_mesh({-30, -10, -10}, {15.01, 10, 10});
    test::append(mushroom, test::box_mesh({15, -30, -30}, {30, 30, 30}));
    const BlockMap blocks = cut_cube(space);
    const GapReport r = report(mushroom, space, blocks, true, kAsItIs, 5);
    expect_halves_add_up(r, space);
    EXPECT_NEAR(r.lower.step_mm3, 45.0 * (60 * 60 - 20 * 20), 0.01 * r.cut_mm3) << "around the stalk";
    EXPECT_NEAR(r.upper.step_mm3, 0, 1e-3);
    EXPECT_NEAR(r.lower.widest_mm, 40 * (2 - std::sqrt(2.0)), 0.5)
        << "between the stalk's edge and two walls";
}

TEST(GapOfHalves, ChangePlacesWhenEverythingIsTurnedOver) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        SCOPED_TRACE(seed);
        test::RandomCase c = test::random_case(seed);
        const int level = c.space.blocks.x / 2;
        const GapReport r = report(c.mesh, c.space, c.blocks, true, c.placement, level);
        expect_halves_add_up(r, c.space);
        // Turned about z: x and y change their signs.
        Mesh turned;
        for (const Vec3d& p : c.placed) turned.vertices.push_back(vec_cast<float>(Vec3d{-p.x, -p.y, p.z}));
        turned.triangles = c.mesh.triangles;
        BlockMap blocks(c.blocks.ny(), c.blocks.nz());
        for (int j = 0; j < blocks.ny(); ++j)
            for (int k = 0; k < blocks.nz(); ++k) {
                const CutRun run = c.blocks(blocks.ny() - 1 - j, k);
                const int nx = c.space.blocks.x;
                if (!run.none())
                    blocks(j, k) = {static_cast<std::int16_t>(nx - run.end),
                                    static_cast<std::int16_t>(nx - run.first)};
            }
        const GapReport t = report(turned, c.space, blocks, true, kAsItIs, c.space.blocks.x - level);
        EXPECT_NEAR(t.lower.step_mm3, r.upper.step_mm3, r.error_mm3 + t.error_mm3 + 1e-3);
        EXPECT_NEAR(t.upper.step_mm3, r.lower.step_mm3, r.error_mm3 + t.error_mm3 + 1e-3);
        EXPECT_NEAR(*t.lower.undercut_mm3, *r.upper.undercut_mm3, r.error_mm3 + t.error_mm3 + 1e-3);
        EXPECT_NEAR(t.lower.widest_mm, r.upper.widest_mm,
                    r.upper.widest_error_mm + t.lower.widest_error_mm + 0.01);
        EXPECT_NEAR(t.upper.widest_mm, r.lower.widest_mm,
                    r.lower.widest_error_mm + t.upper.widest_error_mm + 0.01);
    }
}

}  // namespace
}  // namespace snug
