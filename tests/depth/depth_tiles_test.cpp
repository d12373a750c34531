#include "snug/depth/depth_tiles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "snug/depth/depth_builder.h"
#include "snug/depth/depth_map.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

const DesignSpace kWide{{20, 150, 130}, {10, 1, 1.2}};

Mesh triangles_of(const std::vector<std::array<Vec3d, 3>>& all) {
    Mesh mesh;
    for (const auto& corners : all) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vec3d& corner : corners) mesh.vertices.push_back(vec_cast<float>(corner));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Large triangles of every kind: any three places, thin ones, walls along x, layers, and copies.
Mesh large_triangles_of(Random& random) {
    const Vec3d half = kWide.size() * 0.5;
    const auto place = [&] {
        return Vec3d{random.between(-half.x, half.x), random.between(-half.y, half.y) * 1.1,
                     random.between(-half.z, half.z) * 1.1};
    };
    std::vector<std::array<Vec3d, 3>> all;
    while (all.size() < 60) {
        std::array<Vec3d, 3> corners{place(), place(), place()};
        if (random.chance(0.2)) corners[2] = corners[0] + (corners[1] - corners[0]) * random.unit();
        if (random.chance(0.2)) corners[1].x = corners[2].x = corners[0].x;
        if (random.chance(0.2)) corners[2].z = corners[1].z = corners[0].z;
        if (random.chance(0.2) && !all.empty()) {
            corners = all[all.size() / 2];
            if (random.chance(0.5)) std::swap(corners[0], corners[2]);
            if (random.chance(0.5)) corners[0].x += random.between(-1e-6, 1e-6);
        }
        all.push_back(corners);
    }
    return triangles_of(all);
}

/// Every cell looked at by itself: blocks of one column are never large.
DepthMap column_by_column(const Mesh& mesh, const Placement& placement, Reach reach) {
    DepthMapBuilder builder(kWide, reach);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const Triangle& t : mesh.triangles) {
        std::array<Vec3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = placement(mesh.vertices[t[i]]);
            builder.add_vertex(corners[i]);
        }
        for (int j = 0; j < kWide.blocks.y; ++j)
            for (int k = 0; k < kWide.blocks.z; ++k)
                builder.add_triangle(corners, {{j, j}, {k, k}}, -kInfinity, kInfinity);
    }
    return builder.take();
}

TEST(DepthTiles, LargeTrianglesGiveTheSameDepthsToTheBitAsEveryColumnByItself) {
    for (int seed = 0; seed < test::cases(12); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 4700);
        const Mesh mesh = large_triangles_of(random);
        const Placement placement = place(mesh, {random.between(-20, 20), 0, 0}, {});
        const Reach grown = reach(random.between(-0.3, 2), false);
        const DepthMap expected = column_by_column(mesh, placement, grown);
        const DepthMap found = depth_map(mesh, placement, kWide, grown);
        for (std::size_t column = 0; column < expected.size(); ++column) {
            ASSERT_EQ(found[column].lowest, expected[column].lowest) << column;
            ASSERT_EQ(found[column].highest, expected[column].highest) << column;
        }
    }
}

TEST(DepthTiles, WhatIsHiddenIsNotLookedAtAgain) {
    DepthTiles tiles(64, 64);
    const std::array<Vec3d, 3> front{{{5, -100, -100}, {6, 200, -100}, {7, -100, 200}}};
    const SpreadTriangle first(front);
    const SpreadTriangle::Rectangle seen{0, 32, 0, 32};
    ASSERT_TRUE(first.spans(seen));
    DepthMap depths(64, 64);
    EXPECT_FALSE(tiles.hides(0, 0, first, seen, depths));
    for (int j = 0; j < 32; ++j)
        for (int k = 0; k < 32; ++k) depths(j, k) = {4, 8};
    tiles.added(0, 0, first, seen);
    EXPECT_TRUE(tiles.hides(0, 0, first, seen, depths)) << "between the lowest and the highest that is there";
    auto outer = front;
    for (Vec3d& corner : outer) corner.x += 4;
    EXPECT_FALSE(tiles.hides(0, 0, SpreadTriangle(outer), seen, depths));
}

}  // namespace
}  // namespace snug
