#include "snug/check/part_cut.h"

#include <utility>

#include <gtest/gtest.h>

#include "snug/foam/block_map.h"

#include "tests/support/random.h"

// Parts whose corners lie on blocks' faces, over so many columns that a depth map looks at tiles.

namespace snug {
namespace {

using test::Random;

const DesignSpace kWide{{6, 70, 90}, {10, 2, 3}};

/// A triangle with corners on faces: along y, z or both, and sometimes in one plane of x.
Mesh flush_part(Random& random) {
    Mesh part;
    const int triangles = random.integer(1, 4);
    const bool flat = random.chance(0.5);
    const int layer = random.integer(0, kWide.blocks.x);
    for (int t = 0; t < triangles; ++t) {
        const auto first = static_cast<std::uint32_t>(part.vertices.size());
        for (int corner = 0; corner < 3; ++corner) {
            const int faces[3] = {flat && random.chance(0.9) ? layer : random.integer(0, kWide.blocks.x),
                                  random.integer(0, kWide.blocks.y), random.integer(0, kWide.blocks.z)};
            Vec3d p;
            for (int axis = 0; axis < 3; ++axis) p[axis] = kWide.face(axis, faces[axis]);
            part.vertices.push_back(vec_cast<float>(p));
        }
        part.triangles.push_back({first, first + 1, first + 2});
    }
    // Some lie in a slot between two rows.
    if (random.chance(0.2))
        for (Vec3f& v : part.vertices) v.y = part.vertices.front().y;
    return part;
}

TEST(PartCut, EachPartIsJudgedAsIfItWereAlone) {
    for (const double clearance : {0.0, -0.3, 0.5}) {
        const Reach grown = reach(clearance, false);
        const Placement placement;
        PartCut cut(placement, kWide, grown);
        int uncut = 0;
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            SCOPED_TRACE(seed);
            Random random(seed);
            const Mesh part = flush_part(random);
            bool expected = false;
            for (const CutRun run : block_map(depth_map(part, placement, kWide, grown), kWide, grown))
                expected |= !run.none();
            ASSERT_EQ(cut.cuts(part), expected) << "clearance " << clearance;
            uncut += !expected;
        }
        EXPECT_GT(uncut, clearance > 0 ? -1 : 20);
    }
}

/// Two triangles that cover the whole space and more, between blocks.
Mesh two_sheets(int lower, int upper) {
    Mesh sheets;
    for (const int layer : {lower, upper}) {
        const auto first = static_cast<std::uint32_t>(sheets.vertices.size());
        for (const auto& [j, k] : {std::pair(0, 0), {2 * kWide.blocks.y, 0}, {0, 2 * kWide.blocks.z}})
            sheets.vertices.push_back(
                vec_cast<float>(Vec3d{kWide.face(0, layer), kWide.face(1, j), kWide.face(2, k)}));
        sheets.triangles.push_back({first, first + 1, first + 2});
    }
    return sheets;
}

TEST(PartCut, WhatAnEarlierPartCoveredHidesNoLaterOne) {
    const Placement placement;
    PartCut cut(placement, kWide, reach(0, false));
    EXPECT_EQ(cut.cuts(two_sheets(0, 6)), true);
    EXPECT_EQ(cut.cuts(two_sheets(2, 3)), true);
    EXPECT_EQ(cut.cuts(two_sheets(3, 3)), false);
}

TEST(PartCut, SaysThatItDoesNotKnowBeforeItTakesTooLong) {
    const DesignSpace space{{6, 1000, 1000}, {10, 0.3, 0.3}};
    const Placement placement;
    PartCut cut(placement, space, reach(0, false));
    // Two sheets in slots between layers, joined by a wall in a slot between rows: it cuts nothing anywhere.
    Mesh stairs;
    const auto at = [&](int i, int j, int k) {
        return vec_cast<float>(Vec3d{space.face(0, i), space.face(1, j), space.face(2, k)});
    };
    stairs.vertices = {at(2, 0, 0),      at(2, 500, 0),    at(2, 500, 1000),
                       at(3, 500, 1000), at(3, 1000, 500), at(3, 500, 0)};
    stairs.triangles = {{0, 1, 2}, {1, 2, 3}, {3, 4, 5}};
    int unknown = 0;
    for (int part = 0; part < 200; ++part) {
        const std::optional<bool> answer = cut.cuts(stairs);
        EXPECT_FALSE(answer.value_or(false));
        unknown += !answer;
    }
    EXPECT_GT(unknown, 0);
    EXPECT_LT(unknown, 200);
}

}  // namespace
}  // namespace snug
