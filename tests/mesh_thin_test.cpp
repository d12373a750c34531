#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "snug/mesh/samples.h"
#include "snug/mesh/thin.h"
#include "snug/mesh/triangle_tree.h"

#include "tests/support/random.h"

namespace snug {
namespace {

/// From points of one surface (corners, middles, random places) to all triangles of the other.
double farthest(const Mesh& from, const Mesh& to, test::Random& random) {
    double result = 0;
    for (const Triangle& t : from.triangles) {
        if (from.triangles.size() > 400 && !random.chance(0.05)) continue;
        const double a = random.unit(), b = random.unit() * (1 - a);
        const auto corner = [&](std::size_t i) { return vec_cast<double>(from.vertices[t[i]]); };
        for (const Vec3d p : {corner(0), corner(0) * a + corner(1) * b + corner(2) * (1 - a - b)}) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Triangle& other : to.triangles) {
                const auto at = [&](std::size_t i) { return vec_cast<double>(to.vertices[other[i]]); };
                const Vec3d move = nearest_on_triangle(at(0), at(1), at(2), p) - p;
                nearest = std::min(nearest, dot(move, move));
            }
            result = std::max(result, nearest);
        }
    }
    return std::sqrt(result);
}

TEST(Thin, KeepsToItsLimitAndEveryPointStaysWithinTheStatedDeviation) {
    const std::uint64_t seed = 7;
    SCOPED_TRACE(seed);
    test::Random random(seed);
    for (const char* name : {"torus", "vase", "camera"}) {
        const auto mesh = sample(name);
        ASSERT_TRUE(mesh);
        for (const std::size_t most : {2000u, 300u}) {
            const ThinMesh thin = thinned(*mesh, most);
            EXPECT_LE(thin.mesh.triangles.size(), most);
            EXPECT_GT(thin.mesh.triangles.size(), most / 8);
            EXPECT_GT(thin.deviation, 0);
            EXPECT_LT(thin.deviation, bounds(*mesh).longest_side() / 3);
            EXPECT_LE(farthest(thin.mesh, *mesh, random), thin.deviation + 1e-4) << name << most;
        }
    }
}

TEST(Thin, LeavesAMeshThatIsSmallEnoughAsItIs) {
    const auto mesh = sample("torus");
    ASSERT_TRUE(mesh);
    const ThinMesh same = thinned(*mesh, mesh->triangles.size());
    EXPECT_EQ(same.deviation, 0);
    EXPECT_EQ(same.mesh.triangles, mesh->triangles);
    EXPECT_EQ(same.mesh.vertices.size(), mesh->vertices.size());
}

TEST(Thin, EndsOnSoupsOfEveryKind) {
    const std::uint64_t seed = 11;
    SCOPED_TRACE(seed);
    test::Random random(seed);
    for (int i = 0; i < 200; ++i) {
        Mesh mesh;
        const int count = random.integer(3, 40);
        const double size = random.chance(0.2) ? 0 : 100;
        for (int v = 0; v < count; ++v)
            mesh.vertices.push_back(
                vec_cast<float>(Vec3d{random.between(0, size), random.between(0, size), 5}));
        for (int t = 0; t < 60; ++t) {
            const auto corner = [&] { return static_cast<std::uint32_t>(random.integer(0, count - 1)); };
            mesh.triangles.push_back({corner(), corner(), corner()});
        }
        const ThinMesh thin = thinned(mesh, static_cast<std::size_t>(random.integer(0, 30)));
        EXPECT_LE(thin.mesh.triangles.size(), 30u);
    }
}

}  // namespace
}  // namespace snug
