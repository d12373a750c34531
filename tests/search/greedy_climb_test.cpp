#include "snug/search/greedy_climb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/fit_report.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;

Design cubes(int n, double size) {
    Design design;
    design.space.blocks = Vec3i{n, n, n};
    design.space.block_mm = {size, size, size};
    return design;
}

/// What the method itself makes of a rotation.
FitReport packed_turned(const Mesh& mesh, Design design, const DesignSpace& space, Vec3d rotation_deg) {
    design.space.blocks = space.blocks;
    design.placement.rotation_deg = rotation_deg;
    design.object.units = Unit::mm;
    const auto object = prepare(mesh, design);
    const auto packing = pack(*object, design);
    EXPECT_TRUE(packing && packing->foams) << "the object leaves the space";
    return packing && packing->foams ? packing->fit : FitReport{};
}

DesignSpace space_of(const Design& design) {
    return {*design.space.blocks, design.space.block_mm};
}

TEST(GreedyClimb, ABoxTurnedAFewDegreesComesBackToItsLeastCut) {
    const Mesh box = test::box_mesh({0, 0, 0}, {120, 80, 60});
    Design design = cubes(40, 5);
    for (const Vec3d tilt : {Vec3d{7, 0, 0}, Vec3d{0, -9, 0}, Vec3d{0, 0, 11}, Vec3d{4, -3, 2}}) {
        SCOPED_TRACE(testing::Message() << tilt.x << ", " << tilt.y << ", " << tilt.z);
        design.placement.rotation_deg = tilt;
        const long long start = packed_turned(box, design, space_of(design), tilt).cut_blocks;
        const auto climb = greedy_climb(box, design, space_of(design));
        ASSERT_TRUE(climb);
        EXPECT_GT(start, 24 * 16 * 12);
        EXPECT_LT(climb->cut_blocks, start);
        // One angle alone finds its way back exactly.
        if ((tilt.x != 0) + (tilt.y != 0) + (tilt.z != 0) == 1) {
            EXPECT_EQ(climb->cut_blocks, 24 * 16 * 12);
        }
    }
}

Mesh random_soup(Random& random) {
    Mesh mesh;
    const int triangles = random.integer(1, 20);
    const double size = random.between(20, 160);
    for (int i = 0; i < triangles * 3; ++i)
        mesh.vertices.push_back({static_cast<float>(random.between(0, size)),
                                 static_cast<float>(random.between(0, size / 2)),
                                 static_cast<float>(random.between(0, size / 3))});
    for (std::uint32_t i = 0; i < mesh.vertices.size(); i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
}

Design random_climb_design(Random& random) {
    Design design = cubes(random.integer(18, 26), random.between(8, 12));
    design.placement.rotation_deg = {random.between(-200, 200), random.between(-200, 200),
                                     random.between(-200, 200)};
    design.placement.offset_mm = {random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)};
    design.cut.clearance_mm = random.between(-1, 3);
    design.cut.cut_on_touch = random.chance(0.3);
    if (random.chance(0.7)) design.space.wall_mm = equal_walls(random.between(0, 60));
    return design;
}

TEST(GreedyClimb, IsNeverWorseThanTheStartKeepsTheWallsAndSaysWhatTheMethodSays) {
    int better = 0;
    for (int seed = 0; seed < test::cases(60, 12); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = random_soup(random);
        const Design design = random_climb_design(random);
        const DesignSpace space = space_of(design);
        const auto climb = greedy_climb(mesh, design, space);
        if (!climb) {
            EXPECT_EQ(climb.error().kind, ErrorKind::does_not_fit);
            continue;
        }
        const FitReport start = packed_turned(mesh, design, space, design.placement.rotation_deg);
        const FitReport end = packed_turned(mesh, design, space, climb->rotation_deg);
        EXPECT_LE(end.cut_blocks, start.cut_blocks);
        EXPECT_GE(end.fill_ratio, start.fill_ratio);
        EXPECT_EQ(end.cut_blocks, climb->cut_blocks);
        EXPECT_EQ(end.fill_ratio, climb->fill_ratio);
        const Walls wanted = wanted_wall_mm(design.space);
        for (std::size_t side = 0; side < 6; ++side)
            EXPECT_GE(end.wall_mm[side], std::min(wanted[side], start.wall_mm[side])) << "side " << side;
        better += end.cut_blocks < start.cut_blocks;
    }
    EXPECT_GT(better, test::cases(60, 12) / 2);
}

TEST(GreedyClimb, TakesTheBestOfTheSixNeighboursAndHalvesTheStepOnlyWhereNoneIsBetter) {
    const Mesh mesh = *sample("camera");
    Design design;
    design.placement.rotation_deg = {31, 17, -43};
    const DesignSpace space = space_of(design);
    auto climb = start_climb(prepare_surface(mesh), design, space);
    ASSERT_TRUE(climb);
    int moves = 0;
    while (!ended(*climb)) {
        const Climb before = *climb;
        ASSERT_TRUE(climb_round(*climb, prepare_surface(mesh)));
        EXPECT_EQ(climb->evaluations, before.evaluations + 6);
        long long best = before.cut_blocks;
        for (int neighbour = 0; neighbour < 6; ++neighbour) {
            Vec3d rotation = before.rotation_deg;
            rotation[neighbour / 2] += neighbour % 2 == 0 ? before.step_deg : -before.step_deg;
            best = std::min(best, packed_turned(mesh, design, space, rotation).cut_blocks);
        }
        EXPECT_EQ(climb->cut_blocks, best);
        const bool moved = climb->rotation_deg != before.rotation_deg;
        EXPECT_EQ(moved, best < before.cut_blocks);
        EXPECT_EQ(climb->step_deg, moved ? before.step_deg : before.step_deg / 2);
        moves += moved;
    }
    EXPECT_GT(moves, 0);
}

TEST(GreedyClimb, KeepsAWantedWallThatAFreeClimbGivesUp) {
    int given_up = 0, improved_all_the_same = 0;
    for (int seed = 0; seed < test::cases(150, 30); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 1000);
        const Mesh mesh = random_soup(random);
        Design design = random_climb_design(random);
        design.space.wall_mm.reset();
        const DesignSpace space = space_of(design);
        const auto free = greedy_climb(mesh, design, space);
        if (!free) continue;
        const FitReport start = packed_turned(mesh, design, space, design.placement.rotation_deg);
        const FitReport freely = packed_turned(mesh, design, space, free->rotation_deg);
        const double thinnest = *std::min_element(start.wall_mm.begin(), start.wall_mm.end());
        design.space.wall_mm = equal_walls(thinnest);
        if (*std::min_element(freely.wall_mm.begin(), freely.wall_mm.end()) >= thinnest) continue;
        ++given_up;
        const auto kept = greedy_climb(mesh, design, space);
        ASSERT_TRUE(kept);
        for (const double wall : packed_turned(mesh, design, space, kept->rotation_deg).wall_mm)
            EXPECT_GE(wall, thinnest);
        improved_all_the_same += kept->cut_blocks < start.cut_blocks;
    }
    EXPECT_GT(given_up, test::cases(150, 30) / 50);
    EXPECT_GT(improved_all_the_same, 1);
}

TEST(GreedyClimb, CancelledItStandsAtTheBestOfWhatItLookedAt) {
    const Mesh box = test::box_mesh({0, 0, 0}, {120, 80, 60});
    Design design = cubes(40, 5);
    design.placement.rotation_deg = {0, 0, 20};
    const DesignSpace space = space_of(design);
    const auto start = start_climb(prepare_surface(box), design, space);
    ASSERT_TRUE(start);
    for (const int after : {1, 6, 9}) {
        SCOPED_TRACE(after);
        int calls = 0;
        long long last = start->cut_blocks;
        const auto climb = greedy_climb(box, design, space, [&](const Climb& at) {
            EXPECT_LE(at.cut_blocks, last);
            last = at.cut_blocks;
            return ++calls < after;
        });
        ASSERT_TRUE(climb);
        EXPECT_EQ(calls, after);
        EXPECT_EQ(climb->evaluations, after + 1);
        EXPECT_EQ(climb->cut_blocks, last);
        EXPECT_EQ(packed_turned(box, design, space, climb->rotation_deg).cut_blocks, last);
    }
}

TEST(GreedyClimb, StepByStepOrAtOnceIsTheSameAndAnglesStayInTheSlidersRange) {
    const Mesh mesh = *sample("vase");
    Design design;
    design.placement.rotation_deg = {172, -175, 760};
    const DesignSpace space = space_of(design);
    auto steps = start_climb(prepare_surface(mesh), design, space);
    ASSERT_TRUE(steps);
    while (!ended(*steps)) climb_round(*steps, prepare_surface(mesh));
    const auto whole = greedy_climb(mesh, design, space);
    ASSERT_TRUE(whole);
    EXPECT_EQ(steps->rotation_deg, whole->rotation_deg);
    EXPECT_EQ(steps->evaluations, whole->evaluations);
    for (int angle = 0; angle < 3; ++angle) {
        if (whole->rotation_deg[angle] == design.placement.rotation_deg[angle]) continue;
        EXPECT_LE(std::abs(whole->rotation_deg[angle]), 180);
    }
}

TEST(GreedyClimb, AnObjectThatLeavesTheSpaceIsRefused) {
    const Mesh box = test::box_mesh({0, 0, 0}, {120, 80, 60});
    const Design design = cubes(10, 5);
    const auto climb = greedy_climb(box, design, space_of(design));
    ASSERT_FALSE(climb);
    EXPECT_EQ(climb.error().kind, ErrorKind::does_not_fit);
    EXPECT_NE(text(climb.error().message).find("50 x 50 x 50 mm"), std::string::npos)
        << text(climb.error().message);
}

}  // namespace
}  // namespace snug
