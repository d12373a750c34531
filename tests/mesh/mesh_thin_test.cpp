#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "snug/mesh/thin.h"
#include "snug/mesh/triangle_tree.h"
#include "snug/samples/samples.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

/// The farthest that corners and random places of some triangles of one surface lie from the other.
double farthest(const Mesh& from, const Mesh& to, test::Random& random) {
    double result = 0;
    for (const Triangle& t : from.triangles) {
        if (from.triangles.size() > 400 && !random.chance(0.0005 * test::cases_at_most(100))) continue;
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

void expect_both_within_the_deviation(const Mesh& mesh, const ThinMesh& thin, test::Random& random) {
    constexpr double kRounding = 1e-9;
    EXPECT_LE(farthest(thin.mesh, mesh, random), thin.deviation + kRounding);
    EXPECT_LE(farthest(mesh, thin.mesh, random), thin.deviation + kRounding);
}

Mesh random_soup(test::Random& random) {
    Mesh mesh;
    const int count = random.integer(3, 40);
    const double size = random.chance(0.2) ? 0 : 100;
    for (int v = 0; v < count; ++v)
        mesh.vertices.push_back(vec_cast<float>(
            Vec3d{random.between(0, size), random.between(0, size), random.between(0, size)}));
    for (int t = 0; t < 60; ++t) {
        const auto corner = [&] { return static_cast<std::uint32_t>(random.integer(0, count - 1)); };
        mesh.triangles.push_back({corner(), corner(), corner()});
    }
    return mesh;
}

TEST(Thin, KeepsToItsLimitAndEveryPointStaysWithinTheStatedDeviation) {
    const std::uint64_t seed = 7;
    SCOPED_TRACE(seed);
    test::Random random(seed);
    for (const char* name : {"torus", "vase", "camera"}) {
        const auto mesh = sample(name);
        ASSERT_TRUE(mesh);
        for (const std::size_t most : {2000u, 300u}) {
            SCOPED_TRACE(name + std::to_string(most));
            const ThinMesh thin = thinned(*mesh, most);
            EXPECT_LE(thin.mesh.triangles.size(), most);
            EXPECT_GT(thin.mesh.triangles.size(), most / 8);
            EXPECT_GT(thin.deviation, 0);
            EXPECT_LT(thin.deviation, bounds(*mesh).longest_side() / 3);
            expect_both_within_the_deviation(*mesh, thin, random);
        }
    }
}

TEST(Thin, KeepsTheLineOfARodThatIsThinnerThanACube) {
    // Wide strips above each other and, far above, one that is 100 long and only 0.001 wide.
    Mesh mesh;
    const auto strip = [&mesh](double width, double z, std::uint32_t pieces) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::uint32_t i = 0; i <= pieces; ++i)
            for (const double y : {0.0, width})
                mesh.vertices.push_back(vec_cast<float>(Vec3d{100.0 * i / pieces, y, z}));
        for (std::uint32_t v = first; v + 3 < mesh.vertices.size(); v += 2) {
            mesh.triangles.push_back({v, v + 2, v + 1});
            mesh.triangles.push_back({v + 1, v + 2, v + 3});
        }
    };
    for (int row = 0; row < 20; ++row) strip(100, 0.01 * row, 40);
    strip(0.001, 50, 40);
    test::Random random(3);
    const ThinMesh thin = thinned(mesh, 200);
    EXPECT_LE(thin.mesh.triangles.size(), 200u);
    EXPECT_LT(thin.deviation, 25);
    EXPECT_EQ(bounds(thin.mesh).max.z, 50);
    expect_both_within_the_deviation(mesh, thin, random);
}

TEST(Thin, LeavesAMeshThatIsSmallEnoughAsItIs) {
    const auto mesh = sample("torus");
    ASSERT_TRUE(mesh);
    const ThinMesh same = thinned(*mesh, mesh->triangles.size());
    EXPECT_EQ(same.deviation, 0);
    EXPECT_EQ(same.mesh.triangles, mesh->triangles);
    EXPECT_EQ(same.mesh.vertices.size(), mesh->vertices.size());
}

TEST(Thin, EndsOnSoupsOfEveryKindWithinTheStatedDeviation) {
    const std::uint64_t seed = 11;
    SCOPED_TRACE(seed);
    test::Random random(seed);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const Mesh mesh = random_soup(random);
        const auto most = static_cast<std::size_t>(random.integer(0, 59));
        const ThinMesh thin = thinned(mesh, most);
        EXPECT_LE(thin.mesh.triangles.size(), std::max<std::size_t>(most, 1));
        EXPECT_FALSE(thin.mesh.triangles.empty());
        expect_both_within_the_deviation(mesh, thin, random);
    }
}

}  // namespace
}  // namespace snug
