#include <algorithm>
#include <cmath>
#include <string_view>

#include <gtest/gtest.h>

#include "snug/samples/samples.h"
#include "snug/search/exact_cut.h"
#include "snug/search/quick_cut.h"
#include "snug/search/turn.h"
#include "snug/space/available.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;

TEST(QuickCut, IsJustBelowWhatTheExactKernelCountsAtEveryOffsetItNames) {
    for (const std::string_view name : {"vase", "camera", "figurine"}) {
        const Mesh mesh = *sample(name);
        const PreparedSurface surface = prepare_surface(mesh);
        const SurfacePoints points = surface_points(mesh, 1.0);
        Random random(1);
        for (int i = 0; i < test::cases(12, 4); ++i) {
            SCOPED_TRACE(testing::Message() << name << " " << i);
            Design design = test::roomy_design(mesh, {15, random.chance(0.5) ? 15.0 : 11.0, 22});
            // Clearances that are half a fine column each way are counted as they are.
            design.cut.clearance_mm = design.space.block_mm.y / 16 * random.integer(-2, 3);
            design.space.block_mm.z = design.space.block_mm.y;
            const DesignSpace space = test::space_of(design);
            const double longest = std::sqrt(3.0) * bounds(mesh).longest_side();
            QuickCut quick(space, design.cut, {}, longest, 8, 16);
            const Vec3d rotation_deg = euler_of(rotation_of(test::random_turn(random)));
            const Placement centred = place(surface, rotation_deg, {});
            // Points are relative to the mesh, as are the bounds that count.
            Box3d turned = centred.bounds;
            turned.min = turned.min - centred.shift;
            turned.max = turned.max - centred.shift;
            const auto right = quick.least(points, centred.rotation, turned, 4000);
            ASSERT_EQ(right.size(), 1024u);
            for (std::size_t at = 0; at < right.size(); at += 93) {
                const auto exact = exact_cut(surface, space, design.cut, rotation_deg, right[at].offset_mm,
                                             all_blocks(space.blocks));
                ASSERT_TRUE(exact);
                EXPECT_LE(static_cast<double>(right[at].blocks),
                          1.02 * static_cast<double>(exact->cut_blocks));
                EXPECT_GE(static_cast<double>(right[at].blocks),
                          0.96 * static_cast<double>(exact->cut_blocks));
            }
            for (std::size_t at = 1; at < right.size(); ++at)
                EXPECT_LE(right[at - 1].blocks, right[at].blocks);
        }
    }
}

TEST(QuickCut, NamesNoOffsetWhereWallsLeaveNone) {
    const Mesh box = test::box_mesh({0, 0, 0}, {30, 30, 30});
    const SurfacePoints points = surface_points(box, 2);
    const DesignSpace space{{5, 5, 5}, {10, 10, 10}};
    const Box3d turned = bounds(box);
    const auto offsets = [&](double wall) {
        QuickCut quick(space, {}, {wall, wall, wall, wall, wall, wall}, 60, 4, 4);
        return quick.least(points, Rotation{}, turned, 100);
    };
    EXPECT_EQ(offsets(0).size(), 64u);
    // Three blocks and one on each side fill five: only the middle will do.
    ASSERT_EQ(offsets(10).size(), 1u);
    EXPECT_EQ(offsets(10).front().offset_mm, Vec3d{});
    EXPECT_EQ(offsets(10).front().blocks, 27);
    EXPECT_TRUE(offsets(11).empty());
}

TEST(QuickCut, PointsLieOnTheSurfaceAndLeaveNoHoles) {
    const Mesh sphere = test::sphere_mesh(50, 12);
    const SurfacePoints points = surface_points(sphere, 3);
    EXPECT_GT(points.size(), 3000);
    EXPECT_LT(points.size(), 3 * 31416 / 9);
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Vec3d direction = rotation_of(test::random_turn(random)).row[0];
        double nearest = 1e9;
        for (std::size_t p = 0; p < points.size(); ++p) {
            const Vec3d off = vec_cast<double>(Vec3f{points.x[p], points.y[p], points.z[p]}) - direction * 49;
            nearest = std::min(nearest, std::sqrt(dot(off, off)));
        }
        EXPECT_LT(nearest, 6);
    }
}

}  // namespace
}  // namespace snug
