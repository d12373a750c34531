#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/search/exact_cut.h"
#include "snug/search/greedy_climb.h"
#include "snug/search/placement_search.h"
#include "snug/space/available.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"
#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;
using test::roomy_design;
using test::space_of;

/// What the method itself makes of a placement.
FitReport packed_as_found(const Mesh& mesh, Design design, const FoundPlacement& at) {
    design.placement.rotation_deg = at.rotation_deg;
    design.placement.offset_mm = at.offset_mm;
    const auto object = prepare(mesh, design);
    const auto packing = pack(*object, design);
    EXPECT_TRUE(packing && packing->foams) << "the object leaves the space";
    return packing && packing->foams ? packing->fit : FitReport{};
}

FoundPlacement found(const Mesh& mesh, const Design& design, std::uint64_t seed, long long evaluations) {
    const PreparedSurface surface = prepare_surface(mesh);
    auto search = PlacementSearch::start(mesh, surface, design, space_of(design), seed,
                                         all_blocks(space_of(design).blocks));
    EXPECT_TRUE(search);
    run(*search, evaluations);
    return search->best();
}

TEST(PlacementSearch, ABoxTurnedAtRandomCutsOnlyItsOwnBlocksAgain) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Mesh box = test::turned(test::box_mesh({0, 0, 0}, {60, 45, 66}), test::random_turn(random));
        const Design design = roomy_design(box, {15, 15, 22});
        const FoundPlacement best = found(box, design, seed, 600);
        EXPECT_EQ(best.cut_blocks, 4 * 3 * 3);
        EXPECT_EQ(packed_as_found(box, design, best).cut_blocks, 4 * 3 * 3);
    }
}

TEST(PlacementSearch, AThinPlateLiesAcrossTheInsertionAxis) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Mesh plate = test::turned(test::box_mesh({0, 0, 0}, {150, 110, 6}), test::random_turn(random));
        const Design design = roomy_design(plate, {8, 15, 22});
        const FoundPlacement best = found(plate, design, seed, 600);
        EXPECT_EQ(best.cut_blocks, 10 * 5);
        const PreparedSurface surface = prepare_surface(plate);
        const Placement placement = place(surface, best.rotation_deg, best.offset_mm);
        EXPECT_NEAR(placement.bounds.size().x, 6, 0.01);
    }
}

/// Closed, its axis z, from z = 0 upward.
Mesh cylinder(double radius, double height) {
    constexpr int kAround = 720;
    return test::ringed_mesh(4, kAround, false, [&](int ring, int step) {
        const auto [sine, cosine] = sine_cosine_degrees(360.0 * step / kAround);
        const double r = ring == 0 || ring == 3 ? 0 : radius;
        return Vec3d{r * cosine, r * sine, ring < 2 ? 0 : height};
    });
}

/// Cells that a disc meets in more than its edge.
long long cells_of_disc(const DesignSpace& space, double radius, double y, double z) {
    long long cells = 0;
    for (int j = 0; j < space.blocks.y; ++j) {
        for (int k = 0; k < space.blocks.z; ++k) {
            const double dy = y - std::clamp(y, space.face(1, j), space.face(1, j + 1));
            const double dz = z - std::clamp(z, space.face(2, k), space.face(2, k + 1));
            cells += dy * dy + dz * dz < radius * radius;
        }
    }
    return cells;
}

TEST(PlacementSearch, ACylinderCutsWhatItsClosedFormSays) {
    constexpr double kRadius = 70, kHeight = 30;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(3)); ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Mesh mesh = test::turned(cylinder(kRadius, kHeight), test::random_turn(random));
        const Design design = roomy_design(mesh, {15, 18, 18});
        const DesignSpace space = space_of(design);
        const FoundPlacement best = found(mesh, design, seed, 1500);
        // The least over all offsets, two layers thick; lying down it would cut more.
        long long least = 1LL << 40;
        for (double y = -9; y < 9; y += 0.25)
            for (double z = -9; z < 9; z += 0.25)
                least = std::min(least, 2 * cells_of_disc(space, kRadius, y, z));
        EXPECT_EQ(best.cut_blocks, least);
        // Faces that touch cut nothing, within 0.01 mm.
        const Vec3d at = best.offset_mm;
        EXPECT_GE(best.cut_blocks, 2 * cells_of_disc(space, kRadius - 0.02, at.y, at.z));
        EXPECT_LE(best.cut_blocks, 2 * cells_of_disc(space, kRadius, at.y, at.z));
    }
}

TEST(PlacementSearch, NeverCutsMoreThanTheStartKeepsItsWallsAndIsWhatThePipelineMakesOfIt) {
    int improved = 0, walled = 0;
    const auto seeds = static_cast<std::uint64_t>(test::cases(30));
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const test::RandomDesign soup = test::random_design(random);
        Design design = roomy_design(soup.mesh, soup.space.block_mm);
        design.cut = {soup.clearance, soup.cut_on_touch};
        if (seed % 3 == 0) design.cut.clearance_mm.upper = design.cut.clearance_mm.upper + Vec3d{1, 0.5, 0};
        for (int axis = 0; axis < 3; ++axis) {
            design.placement.rotation_deg[axis] = random.between(-180, 180);
            design.placement.offset_mm[axis] = random.between(-0.4, 0.4) * design.space.block_mm[axis];
        }
        design.space.wall_mm = equal_walls(random.between(0, 4) * design.space.block_mm.x);
        const PreparedSurface surface = prepare_surface(soup.mesh);
        const auto started = PlacementSearch::start(soup.mesh, surface, design, space_of(design), seed,
                                                    all_blocks(space_of(design).blocks));
        if (!started) continue;
        const FitReport before = packed_as_found(soup.mesh, design, started->origin());
        EXPECT_EQ(before.cut_blocks, started->origin().cut_blocks);
        const FoundPlacement best = found(soup.mesh, design, seed, 400);
        const FitReport after = packed_as_found(soup.mesh, design, best);
        EXPECT_EQ(after.cut_blocks, best.cut_blocks);
        EXPECT_LE(best.cut_blocks, before.cut_blocks);
        improved += best.cut_blocks < before.cut_blocks;
        for (std::size_t side = 0; side < 6; ++side) {
            EXPECT_GE(after.wall_mm[side], std::min(design.space.wall_mm->front(), before.wall_mm[side]));
            walled +=
                before.wall_mm[side] >= design.space.wall_mm->front() && design.space.wall_mm->front() > 0;
        }
    }
    EXPECT_GT(improved, static_cast<int>(seeds) / 3);
    EXPECT_GT(walled, static_cast<int>(seeds) * 2 / 3);
}

TEST(PlacementSearch, IsTheSameOnAnyNumberOfThreadsAndForRepeatedSeeds) {
    const Mesh mesh = *sample("figurine");
    Design design;
    design.object.units = Unit::mm;
    const auto with_threads = [&](std::size_t threads, std::uint64_t seed) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return found(mesh, design, seed, test::cases_at_most(700, 400));
    };
    const FoundPlacement one = with_threads(1, 4);
    for (const std::size_t threads : {1u, 2u, 5u}) {
        const FoundPlacement other = with_threads(threads, 4);
        EXPECT_EQ(other.rotation_deg, one.rotation_deg);
        EXPECT_EQ(other.offset_mm, one.offset_mm);
        EXPECT_EQ(other.cut_blocks, one.cut_blocks);
    }
    EXPECT_FALSE(with_threads(1, 5).rotation_deg == one.rotation_deg);
}

TEST(PlacementSearch, CancelledAtAnyStepItHoldsAPlacementThatIsNoWorse) {
    const Mesh mesh = *sample("vase");
    Design design;
    design.object.units = Unit::mm;
    const PreparedSurface surface = prepare_surface(mesh);
    for (int after = 1; after < test::cases_at_most(40, 15); after += 13) {
        SCOPED_TRACE(after);
        auto search =
            PlacementSearch::start(mesh, surface, design, DesignSpace{}, 1, all_blocks(DesignSpace{}.blocks));
        ASSERT_TRUE(search);
        int steps = 0;
        long long last = search->origin().cut_blocks;
        EXPECT_FALSE(run(*search, 1000000, [&](const PlacementSearch& at) {
            EXPECT_LE(at.best().cut_blocks, last);
            last = at.best().cut_blocks;
            return ++steps < after;
        }));
        EXPECT_EQ(steps, after);
        const auto exact = exact_cut(surface, DesignSpace{}, design.cut, search->best().rotation_deg,
                                     search->best().offset_mm, all_blocks(DesignSpace{}.blocks));
        ASSERT_TRUE(exact);
        EXPECT_EQ(exact->cut_blocks, last);
    }
}

TEST(PlacementSearch, FindsWhatTheGreedyClimbFindsAndLess) {
    int left = test::cases_at_most(static_cast<int>(sample_names().size()));
    for (const std::string_view name : sample_names()) {
        if (left-- <= 0) break;
        SCOPED_TRACE(name);
        const Mesh mesh = *sample(name);
        Design design;
        design.object.units = Unit::mm;
        design.placement.rotation_deg = {20, 30, 40};
        const auto greedy = greedy_climb(mesh, design, DesignSpace{});
        ASSERT_TRUE(greedy);
        EXPECT_LT(found(mesh, design, 1, 1500).cut_blocks, greedy->cut_blocks);
    }
}

TEST(PlacementSearch, AnObjectThatLeavesTheSpaceIsRefused) {
    const Mesh box = test::box_mesh({0, 0, 0}, {120, 80, 60});
    Design design;
    design.space.blocks = Vec3i{10, 10, 10};
    design.space.block_mm = {5, 5, 5};
    const PreparedSurface surface = prepare_surface(box);
    const auto search = PlacementSearch::start(box, surface, design, space_of(design), 1,
                                               all_blocks(space_of(design).blocks));
    ASSERT_FALSE(search);
    EXPECT_EQ(search.error().kind, ErrorKind::does_not_fit);
    EXPECT_NE(text(search.error().message).find("50 x 50 x 50 mm"), std::string::npos)
        << text(search.error().message);
}

}  // namespace
}  // namespace snug
