#include "snug/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace snug {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Soup {
    std::vector<Vec3d> vertices;
    std::vector<Triangle> triangles;
};

/// Triangles of all sizes, some of them needles or points, some sharing vertices, far from the origin at
/// times.
Soup random_corners(test::Random& random) {
    Soup soup;
    const int vertices = random.integer(3, 300);
    const Vec3d origin = random.chance(0.3) ? Vec3d{1e5, -3e4, 7e4} : Vec3d{};
    const double size = random.chance(0.5) ? 1 : 100;
    const double flatness = random.chance(0.2) ? 0 : 1;
    for (int i = 0; i < vertices; ++i) {
        soup.vertices.push_back(origin + Vec3d{random.between(-1, 1) * size, random.between(-1, 1) * size,
                                               random.between(-1, 1) * size * flatness});
    }
    const int triangles = random.integer(1, 600);
    for (int i = 0; i < triangles; ++i) {
        Triangle t{};
        const int first = random.integer(0, vertices - 1);
        for (std::uint32_t& v : t) {
            v = static_cast<std::uint32_t>(random.chance(0.7)
                                               ? std::min(first + random.integer(0, 3), vertices - 1)
                                               : random.integer(0, vertices - 1));
        }
        soup.triangles.push_back(t);
    }
    return soup;
}

double brute_distance(const Soup& soup, Vec3d p) {
    double best = kInfinity;
    for (const Triangle& t : soup.triangles) {
        const Vec3d q = nearest_on_triangle(soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]], p);
        best = std::min(best, length(q - p));
    }
    return best;
}

TEST(TriangleTree, NearestPointOfATriangleIsInItAndNoSampleIsNearer) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const auto point = [&] {
            return Vec3d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        };
        const Vec3d a = point();
        const Vec3d b = random.chance(0.1) ? a : point();
        const Vec3d c = random.chance(0.1) ? a : random.chance(0.1) ? (a + b) * 0.5 : point();
        const Vec3d p = random.chance(0.1) ? a : point() * 2;
        const Vec3d q = nearest_on_triangle(a, b, c, p);
        constexpr int kSteps = 60;
        double nearest = kInfinity, to_q = kInfinity;
        for (int i = 0; i <= kSteps; ++i) {
            for (int j = 0; j + i <= kSteps; ++j) {
                const double s = static_cast<double>(i) / kSteps, t = static_cast<double>(j) / kSteps;
                const Vec3d sample = a + (b - a) * s + (c - a) * t;
                nearest = std::min(nearest, length(sample - p));
                to_q = std::min(to_q, length(sample - q));
            }
        }
        EXPECT_LE(length(q - p), nearest + 1e-12);
        EXPECT_LE(to_q, 4.0 / kSteps) << "not in the triangle";
    }
}

TEST(TriangleTree, DistanceEqualsBruteForceOnRandomSoups) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Soup soup = random_corners(random);
        const auto tree = TriangleTree::build(soup.vertices, soup.triangles);
        ASSERT_TRUE(tree);
        for (int i = 0; i < 30; ++i) {
            const Vec3d around = soup.vertices[static_cast<std::size_t>(i) % soup.vertices.size()];
            const double reach = random.chance(0.5) ? 0.1 : 50;
            const Vec3d p = around + Vec3d{random.between(-reach, reach), random.between(-reach, reach),
                                           random.between(-reach, reach)};
            const double expected = brute_distance(soup, p);
            const NearestPoint found = tree->nearest(p, kInfinity);
            constexpr double kRounding = 1e-9;
            EXPECT_NEAR(found.distance, expected, kRounding);
            EXPECT_EQ(length(found.point - p), found.distance);
            // What lies beyond the limit is not found, and good enough is between the nearest and enough.
            const double nearer = expected * 0.9 - kRounding;
            EXPECT_EQ(tree->nearest(p, std::max(nearer, 0.0)).distance, std::max(nearer, 0.0));
            EXPECT_NEAR(tree->nearest(p, expected * 1.1 + 1).distance, expected, kRounding);
            const double enough = expected + random.between(0, 1) + kRounding;
            const double good_enough = tree->nearest(p, kInfinity, enough).distance;
            EXPECT_GE(good_enough, expected - kRounding);
            EXPECT_LE(good_enough, enough);
            EXPECT_NEAR(tree->nearest(p, kInfinity, nearer).distance, expected, kRounding);
        }
    }
}

TEST(TriangleTree, EveryTriangleThatMeetsABoxIsVisitedOnce) {
    for (std::uint64_t seed = 100; seed < 160; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Soup soup = random_corners(random);
        std::sort(soup.triangles.begin(), soup.triangles.end());
        soup.triangles.erase(std::unique(soup.triangles.begin(), soup.triangles.end()), soup.triangles.end());
        const auto tree = TriangleTree::build(soup.vertices, soup.triangles);
        ASSERT_TRUE(tree);
        const Vec3d corner = soup.vertices[0];
        const double size = random.between(0, 20);
        const Box3d box{corner,
                        {random.chance(0.5) ? kInfinity : corner.x + size, corner.y + size, corner.z + size}};
        std::vector<Triangle> visited;
        tree->for_each_near(box, [&](const Triangle& t) { visited.push_back(t); });
        std::sort(visited.begin(), visited.end());
        EXPECT_EQ(std::adjacent_find(visited.begin(), visited.end()), visited.end());
        for (const Triangle& t : soup.triangles) {
            Box3d bounds;
            for (const std::uint32_t v : t) bounds.include(soup.vertices[v]);
            const bool meets = bounds.max.x >= box.min.x && bounds.min.x <= box.max.x &&
                               bounds.max.y >= box.min.y && bounds.min.y <= box.max.y &&
                               bounds.max.z >= box.min.z && bounds.min.z <= box.max.z;
            if (!meets) continue;
            EXPECT_TRUE(std::binary_search(visited.begin(), visited.end(), t));
        }
    }
}

TEST(TriangleTree, NothingHasNoNearestPoint) {
    const auto tree = TriangleTree::build({}, {});
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->nearest({1, 2, 3}, 5).distance, 5);
    tree->for_each_near({{-1, -1, -1}, {1, 1, 1}}, [](const Triangle&) { FAIL(); });
}

TEST(TriangleTree, ThousandsOfTrianglesInOnePointAreNoTrouble) {
    const std::vector<Vec3d> vertices{{1, 2, 3}};
    const std::vector<Triangle> triangles(5000, Triangle{0, 0, 0});
    const auto tree = TriangleTree::build(vertices, triangles);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->nearest({1, 2, 7}, kInfinity).distance, 4);
}

TEST(TriangleTree, BuildingCanBeCancelled) {
    const std::vector<Vec3d> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Triangle> triangles{{0, 1, 2}};
    const auto tree = TriangleTree::build(vertices, triangles, [](double) { return false; });
    ASSERT_FALSE(tree);
    EXPECT_EQ(tree.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace snug
