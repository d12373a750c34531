#include "snug/check/largest_ball.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/gap.h"
#include "snug/check/gap_space.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/random_gap.h"

namespace snug {
namespace {

GapReport report_of_case(const test::RandomCase& c, bool closed) {
    const auto result = gap_report(c.mesh, c.placement, c.space, c.blocks, c.space.blocks.x / 2, closed);
    EXPECT_TRUE(result);
    return *result;
}

TEST(LargestBall, NoBallOnAGridOfPointsBeatsTheLargestBall) {
    for (std::uint64_t seed = 200; seed < 212; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomCase c = test::random_case(seed);
        const GapReport r = report_of_case(c, true);
        EXPECT_NEAR(test::room_in_gap(c, r.widest_at), r.widest_mm / 2, 1e-6);
        EXPECT_LE(r.widest_error_mm, std::max(0.02 * r.widest_mm, 0.25) + 1e-9);
        constexpr double kStep = 4;
        const Box3d all = c.space.box();
        double best = 0;
        for (double x = all.min.x; x < all.max.x; x += kStep) {
            for (double y = all.min.y; y < all.max.y; y += kStep) {
                for (double z = all.min.z; z < all.max.z; z += kStep)
                    best = std::max(best, test::room_in_gap(c, {x, y, z}));
            }
        }
        EXPECT_LE(best, (r.widest_mm + r.widest_error_mm) / 2 + 1e-6);
        EXPECT_GE(best + kStep * std::sqrt(3.0) / 2, r.widest_mm / 2);
    }
}

TEST(LargestBall, NoPointOfACubeHasMoreRoomThanItsCentrePromises) {
    for (std::uint64_t seed = 700; seed < 720; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomCase c = test::random_case(seed);
        const LineLattice lattice(c.space);
        const PrismField cut = cut_field(c.blocks, c.space);
        const auto tree = TriangleTree::build(c.placed, c.mesh.triangles);
        ASSERT_TRUE(tree);
        const GapSpace gap(cut, *tree, c.placed, lattice, nullptr);
        test::Random random(seed);
        for (int cube = 0; cube < 300; ++cube) {
            const Box3d all = c.space.box();
            const Vec3d centre{random.between(all.min.x, all.max.x), random.between(all.min.y, all.max.y),
                               random.between(all.min.z, all.max.z)};
            const double half = random.between(0, random.chance(0.5) ? 1 : 20);
            const GapSpace::Probe probe = gap.probe(centre, half * 2, 0, {});
            const double bound = greatest_room(probe, centre, half);
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3d way{corner & 1 ? half : -half, corner & 2 ? half : -half,
                                corner & 4 ? half : -half};
                const Vec3d p = centre + way * (random.chance(0.7) ? 1 : random.unit());
                EXPECT_LE(gap.probe(p, 0, 0, probe.surroundings).room, std::max(bound, 0.0) + 1e-9);
            }
        }
    }
}

TEST(LargestBall, TheStatedErrorOfTheBallHoldsWhereverTheSearchEnds) {
    for (std::uint64_t seed = 500; seed < 560; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomCase c = test::random_case(seed);
        const LineLattice lattice(c.space);
        const PrismField cut = cut_field(c.blocks, c.space);
        const auto tree = TriangleTree::build(c.placed, c.mesh.triangles);
        ASSERT_TRUE(tree);
        const GapSpace gap(cut, *tree, c.placed, lattice, nullptr);
        const auto fine = largest_ball(gap, cut.bounds(), {0.001, 0.01, 200'000});
        ASSERT_TRUE(fine);
        EXPECT_LE(fine->radius_error, 0.05);
        for (const int most_probes : {1, 9, 100, 1000}) {
            for (const double error : {0.1, 0.5, 2.0, 5.0}) {
                const auto rough = largest_ball(gap, cut.bounds(), {0, error, most_probes});
                ASSERT_TRUE(rough);
                EXPECT_LE(rough->radius, fine->radius + fine->radius_error + 1e-9);
                EXPECT_GE(rough->radius + rough->radius_error, fine->radius - 1e-9);
            }
        }
        for (const std::uint64_t most_work : {0, 100, 10'000}) {
            const auto rough = largest_ball(gap, cut.bounds(), {0, 0.1, 200'000, most_work});
            ASSERT_TRUE(rough);
            EXPECT_LE(rough->radius, fine->radius + fine->radius_error + 1e-9);
            EXPECT_GE(rough->radius + rough->radius_error, fine->radius - 1e-9);
        }
    }
}

TEST(LargestBall, InLoneHolesOfAllSizesItFillsTheWidest) {
    const std::vector<Vec3d> no_vertices;
    const auto no_object = TriangleTree::build(no_vertices, {});
    ASSERT_TRUE(no_object);
    const auto end = 600 + static_cast<std::uint64_t>(test::cases(70));
    for (std::uint64_t seed = 600; seed < end; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const DesignSpace space{{40, 31, 31},
                                {random.between(1, 2), random.between(5, 30), random.between(5, 30)}};
        BlockMap blocks(31, 31);
        double widest = 0;
        for (int holes = random.integer(1, 40); holes > 0; --holes) {
            const int first = random.integer(0, 39), length = random.integer(1, 40 - first);
            CutRun& run = blocks(2 * random.integer(0, 15), 2 * random.integer(0, 15));
            if (!run.none()) continue;
            run = {static_cast<std::int16_t>(first), static_cast<std::int16_t>(first + length)};
            widest =
                std::max(widest, std::min({length * space.block_mm.x, space.block_mm.y, space.block_mm.z}));
        }
        const LineLattice lattice(space);
        const PrismField cut = cut_field(blocks, space);
        const GapSpace gap(cut, *no_object, no_vertices, lattice, nullptr);
        const auto ball = largest_ball(gap, cut.bounds());
        ASSERT_TRUE(ball);
        EXPECT_LE(ball->radius, widest / 2 + 1e-9);
        EXPECT_GE(ball->radius + ball->radius_error, widest / 2 - 1e-9);
        EXPECT_LE(ball->radius_error, std::max(0.125, 0.02 * ball->radius) + 1e-9);
    }
}

TEST(LargestBall, TheLargestBallOfAnOpenObjectMeetsNeitherFoamNorSurfaceNorHull) {
    for (std::uint64_t seed = 300; seed < 320; ++seed) {
        SCOPED_TRACE(seed);
        test::RandomCase c = test::random_case(seed);
        test::Random random(seed);
        std::erase_if(c.mesh.triangles, [&](const Triangle&) { return random.chance(0.3); });
        const GapReport r = report_of_case(c, false);
        const double radius = r.widest_mm / 2;
        ASSERT_GT(radius, 0);
        EXPECT_GE(test::distance_to_foam(c, r.widest_at), radius - 1e-6);
        EXPECT_GE(test::distance_to_surface(c, r.widest_at), radius - 1e-6);
        // The hull is known where lines stand: its rim may reach as far into the ball as lines are apart.
        const double rim = std::hypot(c.space.block_mm.y, c.space.block_mm.z) / 16 * 1.5;
        int in_hull_points = 0, points = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec3d way{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
            if (length(way) > 1 || radius < rim) continue;
            ++points;
            in_hull_points += test::in_hull(c, r.widest_at + way * (radius - rim));
        }
        EXPECT_EQ(in_hull_points, 0) << "of " << points;
    }
}

}  // namespace
}  // namespace snug
