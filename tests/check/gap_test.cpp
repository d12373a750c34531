#include "snug/check/gap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/box.h"
#include "snug/check/line_budget.h"
#include "snug/check/line_hits.h"
#include "snug/depth/depth_map.h"

#include "tests/support/cases.h"
#include "tests/support/gap_cases.h"
#include "tests/support/random.h"
#include "tests/support/random_gap.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

constexpr double kPi = std::numbers::pi;

using test::cut_box;
using test::cut_cube;
using test::kAsItIs;
using test::report;
using test::small_space;

void expect_widest(const GapReport& r, double diameter) {
    EXPECT_LE(r.widest_mm, diameter + 1e-6);
    EXPECT_GE(r.widest_mm + r.widest_error_mm, diameter - 1e-6);
    EXPECT_LE(r.widest_error_mm, std::max(0.02 * r.widest_mm, 0.25) + 1e-9);
}

TEST(Gap, ABoxInALargerBoxHasTheVolumesAndTheBallOfItsFreeLayers) {
    const DesignSpace space = small_space();
    // 12 mm free at one end along x, nothing elsewhere.
    const GapReport r = report(test::box_mesh({-30, -30, -30}, {18, 30, 30}), space, cut_cube(space));
    EXPECT_EQ(r.lines_per_column, 256);
    EXPECT_DOUBLE_EQ(r.cut_mm3, 60 * 60 * 60);
    EXPECT_NEAR(r.hull_mm3, 48 * 60 * 60, 1e-3);
    EXPECT_NEAR(*r.solid_mm3, 48 * 60 * 60, 1e-3);
    EXPECT_NEAR(r.step_mm3, 12 * 60 * 60, 1e-3);
    EXPECT_NEAR(*r.undercut_mm3, 0, 1e-3);
    EXPECT_NEAR(r.error_mm3, 0, 1e-3);
    expect_widest(r, 12);
    EXPECT_NEAR(r.widest_at.x, 24, 0.2);
}

TEST(Gap, FewerLinesWhereAllWouldBeTooMuchWorkTellWhatTheyCost) {
    for (std::uint64_t seed = 900; seed < 930; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomCase c = test::random_case(seed);
        const auto measured = [&](GapLimits limits) {
            const auto result =
                gap_report(c.mesh, c.placement, c.space, c.blocks, c.space.blocks.x / 2, true, {}, limits);
            EXPECT_TRUE(result);
            return *result;
        };
        GapLimits limits;
        limits.ball.most_work = 1000;
        const GapReport fine = measured(limits);
        EXPECT_EQ(fine.lines_per_column, 256);
        double lines = 256.0 * c.space.blocks.y * c.space.blocks.z;
        for (double last = 256; lines > 64; lines /= 4) {
            limits.lines.lines = lines - 1;
            const GapReport coarse = measured(limits);
            EXPECT_LT(coarse.lines_per_column, last);
            last = coarse.lines_per_column;
            EXPECT_EQ(coarse.cut_mm3, fine.cut_mm3);
            // Two standard errors, mostly more: with few lines the estimate itself is rough.
            const double error = 2 * (coarse.error_mm3 + fine.error_mm3);
            EXPECT_NEAR(coarse.hull_mm3, fine.hull_mm3, error);
            EXPECT_NEAR(*coarse.solid_mm3, *fine.solid_mm3, error);
            EXPECT_NEAR(coarse.step_mm3, fine.step_mm3, error);
            EXPECT_NEAR(*coarse.undercut_mm3, *fine.undercut_mm3, error);
            EXPECT_NEAR(coarse.lower.step_mm3 + coarse.upper.step_mm3, coarse.step_mm3,
                        1e-6 * coarse.cut_mm3);
        }
    }
}

TEST(Gap, LinesStayWithinTheirBudgetWhateverTheObject) {
    test::Random random(77);
    const DesignSpace space{{10, 40, 50}, {10, 10, 10}};
    std::vector<Vec3d> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        for (int corner = 0; corner < 3; ++corner)
            vertices.push_back(
                {random.between(-50, 50), random.between(-200, 200), random.between(-250, 250)});
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    for (const double most : {1e3, 1e4, 1e5, 1e6}) {
        const LineLattice lattice = lattice_within({1e9, most}, space, vertices, triangles);
        std::size_t hits = 0;
        const auto swept = sweep_lines(lattice, vertices, triangles,
                                       [&](const LineBand& band) { hits += band.crossings.size(); });
        ASSERT_TRUE(swept);
        EXPECT_LE(static_cast<double>(hits), 1.2 * most);
        EXPECT_LE(lattice_within({most, 1e9}, space, vertices, triangles).lines_per_column() * 2000,
                  1.1 * most);
    }
    EXPECT_EQ(lattice_within({}, space, vertices, std::span(triangles).first(20)).lines_per_column(), 256);
}

TEST(Gap, WallsAlongTheAxesAreMeasuredMuchFinerThanTheLinesStand) {
    const DesignSpace space = small_space();
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Vec3d min{random.between(-29, -5), random.between(-29, -5), random.between(-29, -5)};
        const Vec3d max{random.between(5, 29), random.between(5, 29), random.between(5, 29)};
        const GapReport r = report(test::box_mesh(min, max), space, cut_cube(space));
        const Vec3d size = max - min;
        // Each of four walls is at most 1/512 of a column off, and each corner of the outline three lines.
        const double walls = 2 * 15.0 / 512 * (size.y + size.z), corners = 4 * 3 * 15.0 * 15.0 / 256;
        const double tolerance = size.x * (walls + corners);
        EXPECT_NEAR(*r.solid_mm3, size.x * size.y * size.z, tolerance);
        EXPECT_NEAR(r.step_mm3, 60 * 60 * 60 - size.x * size.y * size.z, tolerance);
    }
}

TEST(Gap, FacesOnBlockFacesLeaveNoGap) {
    const DesignSpace space = small_space();
    const GapReport r = report(test::box_mesh({-30, -30, -30}, {30, 30, 30}), space, cut_cube(space));
    EXPECT_NEAR(r.hull_mm3, r.cut_mm3, 1e-6);
    EXPECT_NEAR(r.step_mm3, 0, 1e-6);
    EXPECT_NEAR(*r.undercut_mm3, 0, 1e-6);
    EXPECT_EQ(r.widest_mm, 0);
    EXPECT_LE(r.widest_error_mm, 1.5);
}

TEST(Gap, ASphereInACubeLeavesItsCornersToTheLargestBall) {
    const DesignSpace space = small_space();
    const Mesh sphere = test::sphere_mesh(25);
    const GapReport r = report(sphere, space, cut_cube(space));
    const double volume = test::enclosed_volume(sphere);
    EXPECT_NEAR(volume, 4 * kPi / 3 * 25 * 25 * 25, 100);
    EXPECT_NEAR(*r.solid_mm3, volume, r.error_mm3 + 1);
    EXPECT_NEAR(r.hull_mm3, volume, r.error_mm3 + 1);
    EXPECT_NEAR(r.step_mm3, r.cut_mm3 - volume, r.error_mm3 + 1);
    EXPECT_NEAR(*r.undercut_mm3, 0, 1e-3);
    EXPECT_LT(r.error_mm3, 0.005 * volume);
    // A ball that touches the three faces of a corner: (30 - radius) sqrt(3) = 25 + radius.
    const double radius = (30 * std::sqrt(3.0) - 25) / (1 + std::sqrt(3.0));
    EXPECT_NEAR(r.widest_mm, 2 * radius, r.widest_error_mm + 0.02);
    EXPECT_LE(r.widest_error_mm, 0.02 * r.widest_mm + 1e-9);
}

TEST(Gap, ATorusAcrossTheInsertionAxisHasItsHoleAsUndercut) {
    const double large = 20, small = 8;
    const DesignSpace space = small_space();
    const Mesh torus = test::torus_mesh(large, small);
    const GapReport lying = report(torus, space, cut_cube(space));
    const double hole =
        kPi * (2 * large * large * small - kPi * large * small * small + 4 * small * small * small / 3);
    EXPECT_NEAR(*lying.solid_mm3, test::enclosed_volume(torus), lying.error_mm3 + 1);
    EXPECT_NEAR(*lying.undercut_mm3, hole, lying.error_mm3 + 0.005 * hole);
    // With its axis along x, lines pass through the hole.
    const GapReport standing =
        report(torus, space, cut_cube(space), true, place(torus, {0, 90, 0}, {0, 0, 0}));
    EXPECT_NEAR(*standing.undercut_mm3, 0, 1);
    EXPECT_NEAR(*standing.solid_mm3, test::enclosed_volume(torus), standing.error_mm3 + 1);
    EXPECT_NEAR(standing.step_mm3, lying.step_mm3 + hole,
                lying.error_mm3 + standing.error_mm3 + 0.005 * hole);
    // Turning the object turns the cube it lies in, too: the same ball fits.
    EXPECT_NEAR(lying.widest_mm, standing.widest_mm,
                std::max(lying.widest_error_mm, standing.widest_error_mm) + 1e-3);
}

TEST(Gap, WhereTwoCubesOverlapTheyCountOnceAndAnInvertedOneIsACavity) {
    const DesignSpace space = small_space();
    Mesh two = test::box_mesh({-30, -30, -30}, {0, 0, 0});
    test::append(two, test::box_mesh({-15, -15, -15}, {15, 15, 15}));
    const double both = 2 * 27000 - 15 * 15 * 15;
    EXPECT_NEAR(*report(two, space, cut_cube(space)).solid_mm3, both, 1e-2);

    Mesh hollow = test::box_mesh({-30, -30, -30}, {30, 30, 30});
    test::append(hollow, test::inside_out(test::box_mesh({-15, -15, -15}, {15, 15, 15})));
    const GapReport r = report(hollow, space, cut_cube(space));
    EXPECT_NEAR(*r.undercut_mm3, 27000, 1e-2);
    EXPECT_NEAR(r.step_mm3, 0, 1e-2);
    expect_widest(r, 30);
}

TEST(Gap, AnOpenObjectHasNoSolidAndNoBallEntersItsHull) {
    const DesignSpace space{{6, 10, 6}, {15, 15, 15}};
    // Two plates one above the other: the hull is the box between them, open at its sides.
    Mesh plates = test::box_mesh({-20, -25, -25}, {20, 25, 25});
    std::erase_if(plates.triangles, [&](const Triangle& t) {
        const auto x = [&](std::size_t i) { return plates.vertices[t[i]].x; };
        return x(0) != x(1) || x(1) != x(2);
    });
    ASSERT_EQ(plates.triangles.size(), 4u);
    const GapReport r = report(plates, space, cut_box(space, {1, 5}, 1, 9, 1, 5), false);
    EXPECT_FALSE(r.solid_mm3);
    EXPECT_FALSE(r.undercut_mm3);
    EXPECT_NEAR(r.hull_mm3, 50 * 50 * 40, 0.01 * 50 * 50 * 40);
    EXPECT_NEAR(r.step_mm3, r.cut_mm3 - r.hull_mm3, 1e-3);
    // Between the plates a ball would have 40 mm, and beside them 50 if it could reach in between.
    EXPECT_NEAR(r.widest_mm, 35, 0.02 * 35 + 0.1);
    EXPECT_GT(std::fabs(r.widest_at.y), 40);
}

TEST(Gap, WhereTheObjectSticksOutOfTheCutOnlyTheCutCounts) {
    const DesignSpace space = small_space();
    const Mesh box = test::box_mesh({-33, -33, -33}, {28, 33, 33});
    const GapReport r = report(box, space, cut_cube(space));
    EXPECT_NEAR(r.hull_mm3, 61 * 66 * 66, 0.01 * r.hull_mm3);
    EXPECT_NEAR(r.step_mm3, 2 * 60 * 60, 1e-3);
    EXPECT_NEAR(*r.undercut_mm3, 0, 1e-3);
    expect_widest(r, 2);
}

TEST(Gap, WithoutACutThereIsNoGap) {
    const DesignSpace space = small_space();
    const GapReport r = report(test::box_mesh({-9, -9, -9}, {9, 9, 9}), space, BlockMap(6, 6));
    EXPECT_EQ(r.cut_mm3, 0);
    EXPECT_EQ(r.step_mm3, 0);
    EXPECT_EQ(r.widest_mm, 0);
    EXPECT_EQ(r.widest_error_mm, 0);
}

TEST(Gap, SolidEqualsTheEnclosedVolumeHoweverTheObjectIsTurned) {
    const DesignSpace space{{12, 12, 12}, {15, 10, 22}};
    const Mesh ellipsoid = test::ringed_mesh(61, 120, false, [](int ring, int step) {
        const double latitude = kPi * ring / 60, longitude = kPi * step / 60;
        const double s = ring % 60 == 0 ? 0 : std::sin(latitude);
        return Vec3d{30 * s * std::cos(longitude), 20 * s * std::sin(longitude), 45 * std::cos(latitude)};
    });
    const double volume = test::enclosed_volume(ellipsoid);
    for (const Vec3d angles : {Vec3d{0, 0, 0}, Vec3d{90, 0, 0}, Vec3d{0, 90, 0}, Vec3d{0, 0, 90},
                               Vec3d{20, 40, 70}, Vec3d{-33, 111, 5}}) {
        const Placement placement = place(ellipsoid, angles, {1, 2, 3});
        const GapReport r = report(ellipsoid, space, BlockMap(12, 12), true, placement);
        EXPECT_NEAR(*r.solid_mm3, volume, r.error_mm3 + 1);
        EXPECT_NEAR(r.hull_mm3, volume, r.error_mm3 + 1);
        EXPECT_LT(r.error_mm3, 0.02 * volume);
    }
}

TEST(Gap, VolumesOfRandomClosedMeshesAgreeWithRandomPoints) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomCase c = test::random_case(seed);
        const GapReport r = report(c.mesh, c.space, c.blocks, true, c.placement);
        test::Random random(seed + 1000);
        const Box3d all = c.space.box();
        const double volume = all.size().x * all.size().y * all.size().z;
        const int points_tried = test::cases(20000);
        int solid = 0, hull = 0, step = 0, undercut = 0;
        for (int i = 0; i < points_tried; ++i) {
            const Vec3d p{random.between(all.min.x, all.max.x), random.between(all.min.y, all.max.y),
                          random.between(all.min.z, all.max.z)};
            const bool cut = test::distance_to_foam(c, p) > 0;
            const bool is_hull = test::in_hull(c, p);
            const bool is_solid = is_hull && test::winding_number(c, p) != 0;
            hull += is_hull;
            solid += is_solid;
            step += cut && !is_hull;
            undercut += cut && is_hull && !is_solid;
        }
        const auto expect_near = [&](double sampled, int points) {
            const double share = static_cast<double>(points) / points_tried;
            // Of what was measured as well as of the points: a small part may have met none of few points.
            const double likely = std::max(share, std::clamp(sampled / volume, 0.0, 1.0));
            const double chance = volume * std::sqrt(likely * (1 - likely) / points_tried);
            EXPECT_NEAR(sampled, share * volume, r.error_mm3 + 4 * chance + 1);
        };
        expect_near(r.hull_mm3, hull);
        expect_near(*r.solid_mm3, solid);
        expect_near(r.step_mm3, step);
        expect_near(*r.undercut_mm3, undercut);
        EXPECT_LT(r.error_mm3, 0.02 * r.hull_mm3);
    }
}

TEST(Gap, TheStatedErrorHoldsAgainstAFinerLattice) {
    int compared = 0, within = 0;
    const auto end = 50 + static_cast<std::uint64_t>(test::cases(30));
    for (std::uint64_t seed = 50; seed < end; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomCase c = test::random_case(seed);
        const GapReport coarse = report(c.mesh, c.space, c.blocks, true, c.placement);
        DesignSpace fine = c.space;
        constexpr int kFiner = 8;
        fine.blocks.y *= kFiner;
        fine.blocks.z *= kFiner;
        fine.block_mm.y /= kFiner;
        fine.block_mm.z /= kFiner;
        BlockMap blocks(fine.blocks.y, fine.blocks.z);
        for (int j = 0; j < blocks.ny(); ++j) {
            for (int k = 0; k < blocks.nz(); ++k) blocks(j, k) = c.blocks(j / kFiner, k / kFiner);
        }
        const GapReport truth = report(c.mesh, fine, blocks, true, c.placement);
        const auto compare = [&](double sampled, double true_value) {
            const double error = std::fabs(sampled - true_value);
            EXPECT_LE(error, 2 * coarse.error_mm3 + truth.error_mm3);
            ++compared;
            within += error <= coarse.error_mm3;
        };
        compare(coarse.hull_mm3, truth.hull_mm3);
        compare(*coarse.solid_mm3, *truth.solid_mm3);
        compare(coarse.step_mm3, truth.step_mm3);
        compare(*coarse.undercut_mm3, *truth.undercut_mm3);
        EXPECT_NEAR(coarse.widest_mm, truth.widest_mm,
                    std::max(coarse.widest_error_mm, truth.widest_error_mm) + 1e-6);
    }
    EXPECT_GE(within, compared * 9 / 10);
}

TEST(Gap, AroundAnObjectThatWasCutWithAClearanceStepIsCutLessHull) {
    for (std::uint64_t seed = 400; seed < 420; ++seed) {
        SCOPED_TRACE(seed);
        test::RandomCase c = test::random_case(seed);
        c.space.blocks = {12, 12, 12};
        const Reach grown = reach(test::Random(seed).between(0.02, 6), false);
        const BlockMap blocks = block_map(depth_map(c.mesh, c.placement, c.space, grown), c.space, grown);
        const GapReport r = report(c.mesh, c.space, blocks, true, c.placement);
        EXPECT_NEAR(r.step_mm3, r.cut_mm3 - r.hull_mm3, 1e-6 * r.cut_mm3);
        EXPECT_NEAR(*r.undercut_mm3, r.hull_mm3 - *r.solid_mm3, 1e-6 * r.cut_mm3);
        EXPECT_GT(r.widest_mm, 2 * grown.mm.x - 0.5);
    }
}

TEST(Gap, TheSameInputGivesTheSameBits) {
    const test::RandomCase c = test::random_case(7);
    const GapReport a = report(c.mesh, c.space, c.blocks, true, c.placement);
    const GapReport b = report(c.mesh, c.space, c.blocks, true, c.placement);
    EXPECT_EQ(a.hull_mm3, b.hull_mm3);
    EXPECT_EQ(a.solid_mm3, b.solid_mm3);
    EXPECT_EQ(a.step_mm3, b.step_mm3);
    EXPECT_EQ(a.undercut_mm3, b.undercut_mm3);
    EXPECT_EQ(a.error_mm3, b.error_mm3);
    EXPECT_EQ(a.widest_mm, b.widest_mm);
    EXPECT_EQ(a.widest_error_mm, b.widest_error_mm);
    EXPECT_EQ(a.widest_at, b.widest_at);
}

TEST(Gap, ProgressNeverRunsBackwardsAndCancelsAtOnce) {
    const DesignSpace space = small_space();
    const Mesh sphere = test::sphere_mesh(25);
    int calls = 0;
    double last = 0;
    const auto whole = gap_report(sphere, kAsItIs, space, cut_cube(space), 3, true, [&](double fraction) {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1);
        last = fraction;
        ++calls;
        return true;
    });
    ASSERT_TRUE(whole);
    ASSERT_GT(calls, 5);
    for (int stop = 1; stop <= calls; ++stop) {
        int seen = 0;
        const auto result = gap_report(sphere, kAsItIs, space, cut_cube(space), 3, true,
                                       [&](double) { return ++seen < stop; });
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().kind, ErrorKind::cancelled);
        EXPECT_EQ(seen, stop);
    }
}

}  // namespace
}  // namespace snug
