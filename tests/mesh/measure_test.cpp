#include "snug/mesh/measure.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "snug/mesh/edges.h"

#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/small_meshes.h"

namespace snug {
namespace {

using Loops = std::vector<std::vector<std::uint32_t>>;
using EdgeSet = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Mesh cube() {
    return test::box_mesh({0, 0, 0}, {2, 2, 2});
}

Mesh moved(Mesh mesh, Vec3f by) {
    for (Vec3f& v : mesh.vertices) v = v + by;
    return mesh;
}

std::pair<std::uint32_t, std::uint32_t> edge(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

/// Every edge that an odd number of triangles use, each triangle toggling its three.
EdgeSet odd_edges(const Mesh& mesh, const std::vector<std::uint32_t>& weld) {
    EdgeSet odd;
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t c[3] = {weld[t[0]], weld[t[1]], weld[t[2]]};
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
        for (int i = 0; i < 3; ++i)
            if (const auto e = edge(c[i], c[(i + 1) % 3]); !odd.insert(e).second) odd.erase(e);
    }
    return odd;
}

/// The loops pass no vertex twice and use exactly the given edges, each once.
void expect_simple_loops_over(const Loops& loops, const EdgeSet& edges) {
    EdgeSet used;
    for (const auto& loop : loops) {
        EXPECT_GE(loop.size(), 3u);
        EXPECT_EQ(std::set<std::uint32_t>(loop.begin(), loop.end()).size(), loop.size());
        for (std::size_t i = 0; i < loop.size(); ++i)
            EXPECT_TRUE(used.insert(edge(loop[i], loop[(i + 1) % loop.size()])).second);
    }
    EXPECT_EQ(used, edges);
}

/// Triangle corners turned and triangles shuffled: the same surface.
Mesh shuffled(Mesh mesh, test::Random& random) {
    for (std::size_t i = mesh.triangles.size(); i > 1; --i)
        std::swap(mesh.triangles[i - 1],
                  mesh.triangles[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
    for (Triangle& t : mesh.triangles) std::rotate(t.begin(), t.begin() + random.integer(0, 2), t.end());
    return mesh;
}

TEST(Measure, ACubeIsOneWatertightPartOfItsVolume) {
    const MeshMeasure m = measure(cube());
    EXPECT_TRUE(m.watertight);
    EXPECT_DOUBLE_EQ(m.volume.value(), 8);
    ASSERT_EQ(m.parts.size(), 1u);
    EXPECT_EQ(m.parts[0].triangles, 12u);
    EXPECT_EQ(m.parts[0].bounds, (Box3d{{0, 0, 0}, {2, 2, 2}}));
    EXPECT_EQ(m.bounds, m.parts[0].bounds);
    EXPECT_EQ(m.part_of_triangle, std::vector<std::uint32_t>(12, 0));
    EXPECT_TRUE(m.holes.empty());
}

TEST(Measure, AnInsideOutCubeHasTheSameVolume) {
    Mesh mesh = cube();
    for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
    EXPECT_DOUBLE_EQ(measure(mesh).volume.value(), 8);
}

TEST(Measure, ACavityIsTakenFromTheVolume) {
    Mesh cavity = moved(test::box_mesh({0, 0, 0}, {1, 1, 1}), {0.5f, 0.5f, 0.5f});
    for (Triangle& t : cavity.triangles) std::swap(t[0], t[1]);
    EXPECT_DOUBLE_EQ(measure(test::joined(cube(), cavity)).volume.value(), 7);
}

TEST(Measure, PartsAreSortedBySizeThenByTheirFirstTriangle) {
    Mesh mesh = test::box_mesh({10, 0, 0}, {11, 1, 1});
    mesh = test::joined(mesh, test::box_mesh({20, 0, 0}, {21, 1, 1}));
    mesh = test::joined(mesh, cube());
    const MeshMeasure m = measure(mesh);
    ASSERT_EQ(m.parts.size(), 3u);
    EXPECT_EQ(m.parts[0].first_triangle, 24u);
    EXPECT_EQ(m.parts[1].first_triangle, 0u);
    EXPECT_EQ(m.parts[2].first_triangle, 12u);
    EXPECT_EQ(m.part_of_triangle[0], 1u);
    EXPECT_EQ(m.part_of_triangle[12], 2u);
    EXPECT_EQ(m.part_of_triangle[24], 0u);
    EXPECT_TRUE(m.watertight);
    EXPECT_DOUBLE_EQ(m.volume.value(), 10);
}

TEST(Measure, CubesThatShareAnEdgeAreOneClosedPart) {
    const MeshMeasure m = measure(test::joined(cube(), moved(cube(), {2, 2, 0})));
    EXPECT_EQ(m.parts.size(), 1u);
    EXPECT_TRUE(m.watertight);  // the common edge has four triangles, two each way
    EXPECT_TRUE(m.holes.empty());
    EXPECT_DOUBLE_EQ(m.volume.value(), 16);
}

TEST(Measure, AnOpenCubeHasOneHoleThatRunsAsItsTrianglesDo) {
    Mesh mesh = cube();
    mesh.triangles.resize(10);  // without +z: 4, 5, 7, 6
    const MeshMeasure m = measure(mesh);
    EXPECT_FALSE(m.watertight);
    EXPECT_FALSE(m.volume.has_value());
    ASSERT_EQ(m.holes.size(), 1u);
    std::vector<std::uint32_t> hole = m.holes[0];
    std::rotate(hole.begin(), std::min_element(hole.begin(), hole.end()), hole.end());
    EXPECT_EQ(hole, (std::vector<std::uint32_t>{4, 6, 7, 5}));
}

TEST(Measure, HolesThatTouchInAVertexAreTwoLoops) {
    Mesh mesh = test::octahedron(0, false);
    // Two opposite sides of the corner 4; all others stay.
    mesh.triangles.erase(mesh.triangles.begin() + 2);
    mesh.triangles.erase(mesh.triangles.begin());
    const MeshMeasure m = measure(mesh);
    ASSERT_EQ(m.holes.size(), 2u);
    EXPECT_EQ(m.holes[0].size(), 3u);
    EXPECT_EQ(m.holes[1].size(), 3u);
}

TEST(Measure, AFlippedTriangleIsNeitherAHoleNorWatertight) {
    Mesh mesh = cube();
    std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
    const MeshMeasure m = measure(mesh);
    EXPECT_FALSE(m.watertight);
    EXPECT_FALSE(m.volume.has_value());
    EXPECT_TRUE(m.holes.empty());
}

TEST(Measure, AMoebiusStripHasOneBoundary) {
    constexpr std::uint32_t kSteps = 16;
    Mesh mesh;
    for (std::uint32_t i = 0; i < kSteps; ++i)
        for (const float side : {-1.f, 1.f})
            mesh.vertices.push_back({static_cast<float>(i), side * static_cast<float>(kSteps - i), side});
    for (std::uint32_t i = 0; i < kSteps; ++i) {
        const std::uint32_t a = 2 * i, b = a + 1;
        const bool turn = i + 1 == kSteps;
        const std::uint32_t c = turn ? 1 : a + 2, d = turn ? 0 : a + 3;
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
    }
    const MeshMeasure m = measure(mesh);
    EXPECT_FALSE(m.watertight);
    ASSERT_EQ(m.holes.size(), 1u);
    EXPECT_EQ(m.holes[0].size(), 2 * kSteps);
}

TEST(Measure, DoubledTrianglesAreNotWatertightUnlessEachWay) {
    Mesh mesh = cube();
    mesh.triangles.push_back(mesh.triangles[0]);
    const MeshMeasure doubled = measure(mesh);
    EXPECT_FALSE(doubled.watertight);
    EXPECT_EQ(doubled.holes.size(), 1u);  // three triangles at each of its edges

    mesh.triangles.push_back({mesh.triangles[0][1], mesh.triangles[0][0], mesh.triangles[0][2]});
    EXPECT_TRUE(measure(mesh).watertight);
}

TEST(Measure, TrianglesWithoutAreaDoNotCloseAnything) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {-0.0f, 0, -0.0f}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 1}};
    const MeshMeasure m = measure(mesh);
    EXPECT_FALSE(m.watertight);
    EXPECT_TRUE(m.holes.empty());
    EXPECT_EQ(m.parts.size(), 1u);

    Mesh with_cube = test::joined(cube(), mesh);
    EXPECT_TRUE(measure(with_cube).watertight);
}

TEST(Measure, AnEmptyMeshHasNothing) {
    const MeshMeasure m = measure({});
    EXPECT_TRUE(m.bounds.empty());
    EXPECT_FALSE(m.watertight);
    EXPECT_TRUE(m.parts.empty());
    EXPECT_TRUE(m.holes.empty());
}

TEST(Weld, JoinsEqualPositionsOnTheFirstAndTakesMinusZeroForZero) {
    Mesh mesh;
    mesh.vertices = {{0, 1, 2}, {5, 5, 5}, {-0.0f, 1, 2}, {0, 1, 2.0000002f}, {5, 5, 5}};
    EXPECT_EQ(welded(mesh), (std::vector<std::uint32_t>{0, 1, 0, 3, 1}));
}

TEST(Weld, AgreesWithComparingEveryPair) {
    test::Random random(20);
    Mesh mesh;
    const auto one = [&] { return static_cast<float>(random.integer(-2, 2)) * 0.125f; };
    for (int i = 0; i < 400; ++i) mesh.vertices.push_back({one() * -1, one(), one()});
    const std::vector<std::uint32_t> weld = welded(mesh);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        std::uint32_t first = 0;
        while (!(mesh.vertices[first] == mesh.vertices[v])) ++first;
        EXPECT_EQ(weld[v], first);
    }
}

TEST(Measure, AClosedSoupIsWatertightOnceWelded) {
    test::Random random(21);
    const Mesh sphere = test::octahedron(4, true);
    const MeshMeasure whole = measure(sphere), soup = measure(shuffled(test::unwelded(sphere), random));
    EXPECT_TRUE(soup.watertight);
    EXPECT_EQ(soup.parts.size(), 1u);
    EXPECT_TRUE(soup.holes.empty());
    EXPECT_NEAR(soup.volume.value(), whole.volume.value(), 1e-12);
    EXPECT_NEAR(whole.volume.value(), 4.18879, 0.08);  // a ball, less what its flat sides cut off
}

/// A cube whose triangles share no vertices and whose corners at 0 are off by so much, each time otherwise.
Mesh loose_cube(float off) {
    const Mesh whole = cube();
    Mesh loose;
    for (const Triangle& t : whole.triangles) {
        const auto first = static_cast<std::uint32_t>(loose.vertices.size());
        for (const std::uint32_t v : t) {
            Vec3f p = whole.vertices[v];
            for (int axis = 0; axis < 3; ++axis)
                if (p[axis] == 0) p[axis] = off * static_cast<float>(loose.vertices.size() % 3);
            loose.vertices.push_back(p);
        }
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    return loose;
}

TEST(Measure, ASeamThatIsOffByRoundingIsClosed) {
    for (const float off : {-2e-14f, 5e-7f}) {
        const MeshMeasure measured = measure(loose_cube(off));
        EXPECT_TRUE(measured.watertight);
        EXPECT_TRUE(measured.holes.empty());
        EXPECT_EQ(measured.parts.size(), 1u);
        ASSERT_TRUE(measured.volume);
        EXPECT_NEAR(*measured.volume, 8, 1e-5);
    }
}

TEST(Measure, ASlitIsNoSeam) {
    const MeshMeasure measured = measure(loose_cube(1e-4f));
    EXPECT_FALSE(measured.watertight);
    EXPECT_FALSE(measured.holes.empty());
}

TEST(Measure, LoopsCoverExactlyTheBoundaryOfAPuncturedSphere) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Mesh mesh = shuffled(test::octahedron(3, true), random);
        mesh.triangles.resize(mesh.triangles.size() - static_cast<std::size_t>(random.integer(1, 300)));
        const bool some_flipped = random.chance(0.3);
        if (some_flipped)
            for (Triangle& t : mesh.triangles)
                if (random.chance(0.1)) std::swap(t[1], t[2]);
        if (random.chance(0.5)) mesh = test::unwelded(mesh);
        const std::vector<std::uint32_t> weld = welded(mesh);
        const MeshMeasure m = measure(mesh);
        expect_simple_loops_over(m.holes, odd_edges(mesh, weld));
        EXPECT_FALSE(m.watertight);
        if (some_flipped) continue;
        EdgeSet directed;  // wound alike, every edge of a loop runs as its triangle does
        for (const Triangle& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) directed.insert({weld[t[i]], weld[t[(i + 1) % 3]]});
        for (const auto& loop : m.holes)
            for (std::size_t i = 0; i < loop.size(); ++i)
                EXPECT_TRUE(directed.count({loop[i], loop[(i + 1) % loop.size()]}));
    }
}

TEST(Measure, LoopsCoverExactlyTheBoundaryOfAnySoup) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Mesh mesh;
        const int vertices = random.integer(3, 12);
        for (int v = 0; v < vertices; ++v) mesh.vertices.push_back({static_cast<float>(v / 2 * 2), 0, 1});
        const auto one = [&] { return static_cast<std::uint32_t>(random.integer(0, vertices - 1)); };
        for (int t = random.integer(1, 40); t > 0; --t) mesh.triangles.push_back({one(), one(), one()});
        const EdgeSet odd = odd_edges(mesh, welded(mesh));
        expect_simple_loops_over(measure(mesh).holes, odd);
        const Loops again = measure(shuffled(mesh, random)).holes;
        expect_simple_loops_over(again, odd);
    }
}

TEST(Measure, HolesDoNotDependOnTheOrderOfTriangles) {
    test::Random random(22);
    Mesh mesh = shuffled(test::octahedron(3, true), random);
    mesh.triangles.resize(300);
    const Loops holes = measure(mesh).holes;
    EXPECT_EQ(measure(shuffled(mesh, random)).holes, holes);
}

TEST(Measure, PartsAgreeWithSpreadingOverSharedVertices) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Mesh mesh = shuffled(test::octahedron(2, true), random);
        mesh.triangles.resize(static_cast<std::size_t>(random.integer(1, 60)));
        const MeshMeasure m = measure(mesh);
        const std::size_t n = mesh.triangles.size();
        std::vector<std::size_t> label(n);
        for (std::size_t t = 0; t < n; ++t) label[t] = t;
        const auto touch = [&](const Triangle& a, const Triangle& b) {
            return std::any_of(a.begin(), a.end(),
                               [&](std::uint32_t v) { return std::count(b.begin(), b.end(), v); });
        };
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b)
                    if (label[b] < label[a] && touch(mesh.triangles[a], mesh.triangles[b])) {
                        label[a] = label[b];
                        changed = true;
                    }
        }
        std::size_t triangles = 0;
        for (const MeshPart& part : m.parts) triangles += part.triangles;
        EXPECT_EQ(triangles, n);
        EXPECT_EQ(m.parts.size(), std::set<std::size_t>(label.begin(), label.end()).size());
        for (std::size_t t = 0; t < n; ++t)
            EXPECT_EQ(m.parts[m.part_of_triangle[t]].first_triangle, label[t]);
    }
}

TEST(Measure, VolumeGrowsWithTheDeterminantOfAnyMap) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const auto row = [&] {
            return Vec3d{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
        };
        const Vec3d rows[3] = {row(), row(), row()}, shift = row() * 100;
        Mesh mesh = test::octahedron(3, false);
        for (Vec3f& v : mesh.vertices) {
            const Vec3d p = vec_cast<double>(v);
            v = vec_cast<float>(Vec3d{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + shift);
        }
        const double determinant = dot(rows[0], cross(rows[1], rows[2]));
        EXPECT_NEAR(measure(mesh).volume.value(), std::fabs(determinant) * 4 / 3,
                    0.01 + 1e-4 * std::fabs(determinant));
    }
}

TEST(Measure, VolumeAgreesWithThrowingDartsAtAConvexBody) {
    test::Random random(23);
    Mesh mesh = test::octahedron(2, true);
    for (Vec3f& v : mesh.vertices) v = {v.x * 3 + v.y, v.y * 2 - v.z, v.z * 4};
    const Box3d box = bounds(mesh);
    const Vec3d size = box.size();
    constexpr int kDarts = 40000;
    int inside = 0;
    for (int i = 0; i < kDarts; ++i) {
        const Vec3d p{random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y),
                      random.between(box.min.z, box.max.z)};
        inside += std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
            const Vec3d a = vec_cast<double>(mesh.vertices[t[0]]), b = vec_cast<double>(mesh.vertices[t[1]]),
                        c = vec_cast<double>(mesh.vertices[t[2]]);
            return dot(p - a, cross(b - a, c - a)) <= 0;
        });
    }
    const double darts = size.x * size.y * size.z * inside / kDarts;
    EXPECT_NEAR(measure(mesh).volume.value(), darts, 0.02 * darts);  // four standard deviations
}

}  // namespace
}  // namespace snug
