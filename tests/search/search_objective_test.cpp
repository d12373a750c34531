#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "snug/object/prepare.h"
#include "snug/samples/samples.h"
#include "snug/search/direction_map.h"
#include "snug/search/objective.h"
#include "snug/search/placement_search.h"
#include "snug/search/search_design.h"
#include "snug/search/turn.h"
#include "snug/space/available.h"

#include "tests/support/random.h"
#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;
using test::roomy_design;
using test::space_of;

Object prepared_sample(const char* name) {
    Object object;
    object.mesh = *sample(name);
    prepare_for_many(object);
    return object;
}

FoundPlacement found_with(const Mesh& mesh, Design design, Objective objective, long long evaluations) {
    design.search.weight.fill(0);
    design.search.weight[static_cast<std::size_t>(objective)] = 1;
    const PreparedSurface surface = prepare_surface(mesh);
    auto search = PlacementSearch::start(mesh, surface, design, space_of(design), 2,
                                         all_blocks(space_of(design).blocks));
    EXPECT_TRUE(search);
    run(*search, evaluations);
    EXPECT_LE(search->best().score, search->origin().score);
    return search->best();
}

PlacementMeasures measured(const Mesh& mesh, const Design& design, const FoundPlacement& at) {
    const auto exact = exact_cut(prepare_surface(mesh), space_of(design), design.cut, at.rotation_deg,
                                 at.offset_mm, all_blocks(space_of(design).blocks));
    EXPECT_TRUE(exact);
    return exact ? measures(*exact, space_of(design)) : PlacementMeasures{};
}

TEST(SearchObjective, MeasuresOfABoxAreThoseOfItsSides) {
    const Mesh box = test::box_mesh({0, 0, 0}, {20, 30, 30});
    Design design = roomy_design(box, {15, 15, 15});
    design.space.blocks = Vec3i{4, 4, 4};
    const auto at = measured(box, design, {});
    EXPECT_EQ(at.cut_blocks, 2 * 2 * 2);
    // 20 mm in the middle of two blocks.
    EXPECT_NEAR(at.gap_mm, 5, 1e-6);
    EXPECT_EQ(at.depth_mm, 30);
    EXPECT_EQ(at.bearing, 0);
    // On the floor of its cavity every lower end bears and no upper one does.
    const auto lower = measured(box, design, {{}, {-5, 0, 0}, 0, 0, 0});
    EXPECT_EQ(lower.bearing, 0.5);
    EXPECT_NEAR(lower.gap_mm, 5, 1e-6);
}

TEST(SearchObjective, ABoxStandsAsSteadilyAsItsBaseIsWideForItsHeight) {
    const Steadiness steadiness(test::box_mesh({0, 0, 0}, {80, 30, 60}));
    const auto expected = [](double height, double least_width) {
        return least_width / std::sqrt(height * height + least_width * least_width);
    };
    EXPECT_NEAR(steadiness(Rotation{}), expected(80, 30), 1e-3);
    EXPECT_NEAR(steadiness(rotation_from_euler({0, 0, 90})), expected(30, 60), 1e-3);
    EXPECT_NEAR(steadiness(rotation_from_euler({0, 90, 0})), expected(60, 30), 1e-3);
    EXPECT_LE(steadiness(rotation_from_euler({0, 0, 30})), 0);  // on an edge
}

TEST(SearchObjective, AThinPlateLiesAcrossTheAxisForTheLeastDepthAndLiesFlat) {
    Random random(1);
    const Mesh plate = test::turned(test::box_mesh({0, 0, 0}, {150, 110, 9}), test::random_turn(random));
    const Design design = roomy_design(plate, {15, 15, 22});
    for (const Objective objective : {Objective::depth, Objective::flat}) {
        const FoundPlacement best = found_with(plate, design, objective, 900);
        EXPECT_LT(place(plate, best.rotation_deg, {}).bounds.size().x, 9.5);
        if (objective == Objective::depth) {
            EXPECT_EQ(measured(plate, design, best).depth_mm, 15);
        }
    }
}

TEST(SearchObjective, GapAndBearingImproveWhereTheyAreWhatCounts) {
    const Mesh mesh = *sample("vase");
    Design design;
    design.object.units = Unit::mm;
    design.placement.rotation_deg = {10, 20, 30};
    const FoundPlacement start{design.placement.rotation_deg, {}, 0, 0, 0};
    const auto before = measured(mesh, design, start);
    EXPECT_LT(measured(mesh, design, found_with(mesh, design, Objective::gap, 500)).gap_mm, before.gap_mm);
    EXPECT_GT(measured(mesh, design, found_with(mesh, design, Objective::bearing, 500)).bearing,
              before.bearing);
}

TEST(SearchObjective, AnAxisKeptUprightStaysUprightEvenFromAStartThatIsNot) {
    const Object object = prepared_sample("camera");
    for (const Upright upright : {Upright::plus_z, Upright::minus_y, Upright::plus_x, Upright::minus_x}) {
        Design design;
        design.object.units = Unit::mm;
        design.search.upright = upright;
        const auto report = search_design(object, design, {false, true, 600});
        ASSERT_TRUE(report);
        EXPECT_NEAR(rotation_from_euler(design.placement.rotation_deg)(direction(upright)).x, 1, 1e-9);
        EXPECT_GT(report->evaluations, 500);
        EXPECT_EQ(report->method, "placement");
    }
}

TEST(SearchObjective, ASearchInAFittedCaseKeepsItsWalls) {
    const Object object = prepared_sample("figurine");
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(30);
    const auto report = search_design(object, design, {true, true, 600});
    ASSERT_TRUE(report);
    ASSERT_TRUE(design.space.blocks);
    const auto exact =
        exact_cut(*object.prepared, space_of(design), design.cut, design.placement.rotation_deg,
                  design.placement.offset_mm, all_blocks(space_of(design).blocks));
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->cut_blocks, report->cut_blocks);
    for (const double wall : exact->wall_mm) EXPECT_GE(wall, 30);
}

TEST(SearchObjective, DistinctPlacementsDifferByMoreThanTwentyDegreesAndAreWhatTheyClaim) {
    const Mesh mesh = *sample("figurine");
    const PreparedSurface surface = prepare_surface(mesh);
    Design design;
    design.object.units = Unit::mm;
    auto search =
        PlacementSearch::start(mesh, surface, design, DesignSpace{}, 1, all_blocks(DesignSpace{}.blocks));
    ASSERT_TRUE(search);
    run(*search, 2500);
    const auto placements = search->distinct();
    EXPECT_GE(placements.size(), 3u);
    EXPECT_LE(placements.size(), 6u);
    EXPECT_EQ(placements.front().rotation_deg, search->best().rotation_deg);
    const BlockSymmetry symmetry(DesignSpace{}, true);
    const double twenty = sine_cosine_degrees(10).cosine;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const auto exact = exact_cut(surface, DesignSpace{}, design.cut, placements[i].rotation_deg,
                                     placements[i].offset_mm, all_blocks(DesignSpace{}.blocks));
        ASSERT_TRUE(exact);
        EXPECT_EQ(exact->cut_blocks, placements[i].cut_blocks);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_LT(symmetry.closest(turn_of(rotation_from_euler(placements[i].rotation_deg)),
                                       turn_of(rotation_from_euler(placements[j].rotation_deg))),
                      twenty + 1e-6);
    }
}

TEST(DirectionMap, EqualAreasFaceEqualShares) {
    const Mesh box = test::box_mesh({0, 0, 0}, {50, 40, 30});
    const PreparedSurface surface = prepare_surface(box);
    const DirectionMap map(box, surface, Design{}, DesignSpace{}, 600, all_blocks(DesignSpace{}.blocks));
    int polar = 0;
    Vec3d sum;
    for (const DirectionCut& cut : map.cuts()) {
        EXPECT_NEAR(dot(cut.direction, cut.direction), 1, 1e-12);
        polar += cut.direction.x > 0.5;  // half of the half sphere's area (Archimedes)
        sum = sum + cut.direction;
    }
    EXPECT_EQ(polar, 300);
    EXPECT_NEAR(sum.x / 600, 0.5, 1e-3);
    EXPECT_NEAR(sum.y / 600, 0, 0.01);
    EXPECT_NEAR(sum.z / 600, 0, 0.01);
}

}  // namespace
}  // namespace snug
