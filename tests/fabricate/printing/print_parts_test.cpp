#include "snug/fabricate/printing/print_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/rotation.h"
#include "snug/fabricate/printing/print_bed.h"
#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_solid.h"

#include "tests/support/cases.h"
#include "tests/support/closedness.h"
#include "tests/support/print_design.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Heights;

TEST(PrintParts, PiecesAreTheFewestAndAsEqualAsCanBe) {
    const PrintCuts cuts = print_cuts({15, 18, 18}, {15, 15, 22}, {250, 210, 210});
    EXPECT_EQ(cuts.lines[0], (std::vector{0, 7, 15}));
    EXPECT_EQ(cuts.pieces(1) * cuts.pieces(2), 4);
    // 10 x 30 blocks of 10 mm on a bed 350 wide and 120 deep need no cut, nor does the quarter turn.
    EXPECT_EQ(print_cuts({1, 10, 30}, {10, 10, 10}, {350, 120, 50}).pieces(2), 1);
    const PrintCuts turned = print_cuts({1, 30, 10}, {10, 10, 10}, {350, 120, 50});
    EXPECT_TRUE(turned.turned);
    EXPECT_EQ(turned.pieces(1) * turned.pieces(2), 1);
}

TEST(PrintParts, EveryBlockIsInOnePartAndPartsAreJoinedBySides) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Vec3i blocks{random.integer(1, 8), random.integer(1, 12), random.integer(1, 12)};
        const Heights heights = test::random_heights(random, blocks);
        const PrintLayout layout = print_layout(
            heights,
            print_cuts({*std::max_element(heights.begin(), heights.end()), blocks.y, blocks.z}, {1, 1, 1},
                       {random.between(1, 9), random.between(1, 9), random.between(1, 9)}));
        std::set<std::array<int, 3>> seen;
        for (const PrintPart& part : layout.parts)
            for (int j = 0; j < part.runs.ny(); ++j)
                for (int k = 0; k < part.runs.nz(); ++k)
                    for (int i = 0; i < part.runs(j, k).end; ++i) {
                        EXPECT_TRUE(
                            seen.insert({part.first.x + i, part.first.y + j, part.first.z + k}).second);
                        EXPECT_LT(part.first.x + i, heights(part.first.y + j, part.first.z + k));
                    }
        EXPECT_EQ(seen.size(), static_cast<std::size_t>(std::accumulate(heights.begin(), heights.end(), 0)));
    }
}

/// The circle of a bore's clearance lies within its prism, and the prism within the foam of both parts.
TEST(PrintJoints, DowelsFitTheirBoresAndBoresStayInsideTheFoam) {
    int bores = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const test::PrintDesign design = test::random_print_design(random);
        const PrintOptions options = test::random_print_options(random);
        if (!holds_block(options.bed_mm, design.space.block_mm)) continue;
        const Heights heights = test::lower_heights(design.foams);
        const int levels = *std::max_element(heights.begin(), heights.end());
        const PrintLayout layout = print_layout(
            heights, print_cuts({levels, heights.ny(), heights.nz()}, design.space.block_mm, options.bed_mm));
        const Joints joints = place_joints(layout, design.space.block_mm, options);
        bores += static_cast<int>(joints.bores.size());
        for (const Bore& bore : joints.bores) {
            for (int sample = 0; sample < 40; ++sample) {
                const SineCosine turn = sine_cosine_degrees(random.between(0, 360));
                const double radius = bore_corner_radius_mm(options) + 1.9;
                const double along = random.between(-1, 1) * (bore_depth_mm(options) + 1.9);
                Vec3d p = bore.centre_mm;
                p[bore.axis] += along;
                p[(bore.axis + 1) % 3] += radius * turn.cosine;
                p[(bore.axis + 2) % 3] += radius * turn.sine;
                Vec3i at;
                for (int a = 0; a < 3; ++a)
                    at[a] = static_cast<int>(std::floor(p[a] / design.space.block_mm[a]));
                const PrintPart& part =
                    layout.parts[static_cast<std::size_t>(along < 0 ? bore.before : bore.after)];
                at = at - part.first;
                ASSERT_TRUE(part.runs.contains(at.y, at.z));
                ASSERT_TRUE(part.runs(at.y, at.z).contains(at.x));
            }
        }
    }
    EXPECT_GT(bores, 100);
}

TEST(PrintSolid, PartsAreClosedAndHaveTheVolumeOfTheirBlocksLessTheirBores) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const test::PrintDesign design = test::random_print_design(random);
        const PrintOptions options = test::random_print_options(random);
        if (!holds_block(options.bed_mm, design.space.block_mm)) continue;
        const Heights heights = test::lower_heights(design.foams);
        const int levels = *std::max_element(heights.begin(), heights.end());
        const PrintLayout layout = print_layout(
            heights, print_cuts({levels, heights.ny(), heights.nz()}, design.space.block_mm, options.bed_mm));
        const Joints joints = place_joints(layout, design.space.block_mm, options);
        for (int i = 0; i < static_cast<int>(layout.parts.size()); ++i) {
            const bool lid = random.chance(0.5);
            const Solid solid = part_solid(layout, i, joints.bores, design.space.block_mm, options,
                                           {lid, layout.cuts.turned});
            ASSERT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
            ASSERT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
            const auto own = std::count_if(joints.bores.begin(), joints.bores.end(),
                                           [&](const Bore& b) { return b.before == i || b.after == i; });
            const double foam = static_cast<double>(layout.parts[static_cast<std::size_t>(i)].blocks()) *
                                design.space.block_volume();
            ASSERT_NEAR(test::signed_volume(solid.vertices, solid.triangles),
                        foam - static_cast<double>(own) * bore_volume_mm3(options), foam * 1e-5);
        }
    }
}

TEST(PrintSolid, ADowelIsWithinItsCircleAndFacesOutward) {
    const PrintOptions options;
    const Solid dowel = dowel_solid(options);
    EXPECT_TRUE(test::every_edge_has_two_triangles(dowel.triangles));
    const double circle = 3.141592653589793 * 9 * options.dowel_length_mm;
    const double volume = test::signed_volume(dowel.vertices, dowel.triangles);
    EXPECT_LT(volume, circle);
    EXPECT_GT(volume, 0.97 * circle);
    EXPECT_GT(bore_volume_mm3(options) * 2, circle);
}

TEST(PrintBed, ThingsLieApartAndOnFewBeds) {
    const std::vector<Vec3d> sizes{{100, 50, 1}, {100, 80, 1}, {60, 10, 1}, {200, 100, 1}};
    const auto places = places_on_beds(sizes, {210, 200, 10});
    for (const BedPlace& place : places) EXPECT_EQ(place.bed, places[0].bed);
}

TEST(PrintBed, ThingsGoRoundEachOtherWhereRowsWouldTakeAnotherBed) {
    const std::vector<Vec3d> sizes{{130, 80, 1}, {80, 130, 1}, {130, 80, 1}, {80, 130, 1}};
    for (const BedPlace& place : places_on_beds(sizes, {215, 215, 10})) EXPECT_EQ(place.bed, 0);
}

TEST(PrintBed, ThingsKeepTheirGapOnTheBed) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(20, 5)); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed + 700);
        const Vec3d bed{random.between(120, 300), random.between(120, 300), 10};
        std::vector<Vec3d> sizes;
        for (int i = random.integer(1, 20); i > 0; --i)
            sizes.push_back({random.between(1, bed.x), random.between(1, bed.y), 1});
        const auto places = places_on_beds(sizes, bed);
        ASSERT_EQ(places.size(), sizes.size());
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const BedPlace& a = places[i];
            EXPECT_GE(std::min(a.x, a.y), 0);
            EXPECT_LE(a.x + sizes[i].x, bed.x + 1e-5);
            EXPECT_LE(a.y + sizes[i].y, bed.y + 1e-5);
            for (std::size_t k = 0; k < i; ++k) {
                const BedPlace& b = places[k];
                if (a.bed != b.bed) continue;
                const double along_x = std::max(b.x - a.x - sizes[i].x, a.x - b.x - sizes[k].x),
                             along_y = std::max(b.y - a.y - sizes[i].y, a.y - b.y - sizes[k].y);
                EXPECT_GE(std::max(along_x, along_y), 5 - 1e-5);
            }
        }
    }
}

}  // namespace
}  // namespace snug
