#include "tests/support/voxels.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/closedness.h"

namespace snug::test {
namespace {

using Lattice = std::tuple<int, int, int>;  ///< level, J, K

/// The solid as an array of blocks, for tests alone, with everything that can be read off one.
struct Voxels {
    Vec3i n;
    std::vector<char> solid;

    Voxels(const Grid<Run>& runs, int levels)
        : n{levels, runs.ny(), runs.nz()}, solid(static_cast<std::size_t>(n.x) * n.y * n.z) {
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k)
                for (int i = runs(j, k).first; i < runs(j, k).end; ++i) solid[index(i, j, k)] = 1;
    }
    [[nodiscard]] std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(i) * n.y + j) * n.z + k;
    }
    [[nodiscard]] bool at(int i, int j, int k) const {
        return i >= 0 && j >= 0 && k >= 0 && i < n.x && j < n.y && k < n.z && solid[index(i, j, k)] != 0;
    }

    /// Not the same along any axis in the eight blocks around the point.
    [[nodiscard]] bool is_corner(int X, int J, int K) const {
        bool same[3] = {true, true, true};
        for (int octant = 0; octant < 8; ++octant) {
            const auto block = [&](int o) {
                return at(X - 1 + (o & 1), J - 1 + (o >> 1 & 1), K - 1 + (o >> 2));
            };
            for (int axis = 0; axis < 3; ++axis) same[axis] &= block(octant) == block(octant ^ (1 << axis));
        }
        return !same[0] && !same[1] && !same[2];
    }
    [[nodiscard]] std::set<Lattice> corners() const {
        std::set<Lattice> found;
        for (int X = 0; X <= n.x; ++X)
            for (int J = 0; J <= n.y; ++J)
                for (int K = 0; K <= n.z; ++K)
                    if (is_corner(X, J, K)) found.insert({X, J, K});
        return found;
    }
    /// Block faces that show in each plane, by axis, plane, and whether they look along the axis.
    [[nodiscard]] std::map<std::tuple<int, int, bool>, long long> shown_faces() const {
        std::map<std::tuple<int, int, bool>, long long> faces;
        for (int i = 0; i <= n.x; ++i)
            for (int j = 0; j <= n.y; ++j)
                for (int k = 0; k <= n.z; ++k) {
                    const bool here = at(i, j, k);
                    if (at(i - 1, j, k) != here) ++faces[{0, i, !here}];
                    if (at(i, j - 1, k) != here) ++faces[{1, j, !here}];
                    if (at(i, j, k - 1) != here) ++faces[{2, k, !here}];
                }
        return faces;
    }
    [[nodiscard]] long long blocks() const { return std::accumulate(solid.begin(), solid.end(), 0LL); }
};

/// Vertices of a solid in whole_space as lattice points, the upper half turned over to stand like the lower.
std::vector<Vec3i> lattice_points(const Solid& solid, const DesignSpace& space, bool upper) {
    std::vector<Vec3i> points;
    for (const Vec3f v : solid.vertices) {
        Vec3i p = vec_cast<int>(v) + space.blocks;
        EXPECT_EQ(vec_cast<float>(p - space.blocks), v);
        EXPECT_TRUE(p.x % 2 == 0 && p.y % 2 == 0 && p.z % 2 == 0);
        p = {p.x / 2, p.y / 2, p.z / 2};
        points.push_back(upper ? Vec3i{space.blocks.x - p.x, p.y, p.z} : p);
    }
    return points;
}

Vec3i normal_of(const std::vector<Vec3i>& points, const Triangle& t) {
    return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

/// Every triangle is upright or level, has an area, and each plane has the area of its block faces that show.
void expect_faces_as_shown(const std::vector<Vec3i>& points, const Solid& solid, const Voxels& voxels,
                           bool upper) {
    std::map<std::tuple<int, int, bool>, long long> doubled, expected;
    for (const Triangle& t : solid.triangles) {
        const Vec3i normal = upper ? -normal_of(points, t) : normal_of(points, t);
        ASSERT_EQ((normal.x != 0) + (normal.y != 0) + (normal.z != 0), 1) << "degenerate or slanting";
        const int axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
        doubled[{axis, points[t[0]][axis], normal[axis] > 0}] += std::abs(normal[axis]);

        // A point well inside the triangle has foam on its inner side and none on the other.
        const auto mixed = [&](int i) {
            return 0.2113 * points[t[0]][i] + 0.3571 * points[t[1]][i] + 0.4316 * points[t[2]][i];
        };
        Vec3i inner, outer;
        for (int i = 0; i < 3; ++i) inner[i] = outer[i] = static_cast<int>(std::floor(mixed(i)));
        inner[axis] = points[t[0]][axis] - (normal[axis] > 0 ? 1 : 0);
        outer[axis] = points[t[0]][axis] - (normal[axis] > 0 ? 0 : 1);
        ASSERT_TRUE(voxels.at(inner.x, inner.y, inner.z));
        ASSERT_FALSE(voxels.at(outer.x, outer.y, outer.z));
    }
    for (const auto& [plane, faces] : voxels.shown_faces()) expected[plane] = 2 * faces;
    ASSERT_EQ(doubled, expected);
}

void expect_no_vertex_inside_an_edge(const std::vector<Vec3i>& points, const Solid& solid) {
    std::set<Lattice> all;
    for (const Vec3i p : points) all.insert({p.x, p.y, p.z});
    for (const Triangle& t : solid.triangles) {
        for (std::size_t side = 0; side < 3; ++side) {
            const Vec3i from = points[t[side]], d = points[t[(side + 1) % 3]] - from;
            const int steps = std::gcd(std::gcd(std::abs(d.x), std::abs(d.y)), std::abs(d.z));
            for (int i = 1; i < steps; ++i)
                ASSERT_EQ(
                    all.count({from.x + d.x / steps * i, from.y + d.y / steps * i, from.z + d.z / steps * i}),
                    0u);
        }
    }
}

/// The triangles around each vertex are one fan: the surface is nowhere pinched in a vertex.
void expect_one_fan_each(const Solid& solid) {
    std::vector<std::map<std::uint32_t, std::uint32_t>> next(solid.vertices.size());
    for (const Triangle& t : solid.triangles)
        for (std::size_t i = 0; i < 3; ++i) next[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    for (const auto& around : next) {
        ASSERT_FALSE(around.empty()) << "a vertex that no triangle uses";
        std::size_t steps = 0;
        std::uint32_t at = around.begin()->first;
        do {
            at = around.at(at);
            ++steps;
        } while (at != around.begin()->first && steps <= around.size());
        ASSERT_EQ(steps, around.size());
    }
}

}  // namespace

void expect_sound(const Solid& solid, const Grid<Run>& runs, int levels, Half half) {
    const bool upper = half == Half::lid;
    const DesignSpace space = whole_space(runs, levels);
    const Voxels voxels(runs, levels);
    const std::vector<Vec3i> points = lattice_points(solid, space, upper);
    ASSERT_TRUE(every_edge_has_two_triangles(solid.triangles));
    ASSERT_TRUE(closed_when_welded(solid.vertices, solid.triangles));
    ASSERT_EQ(signed_volume(solid.vertices, solid.triangles), 8.0 * static_cast<double>(voxels.blocks()));
    std::set<Lattice> standing;
    for (const Vec3i p : points) standing.insert({p.x, p.y, p.z});
    ASSERT_EQ(standing, voxels.corners());
    expect_faces_as_shown(points, solid, voxels, upper);
    expect_no_vertex_inside_an_edge(points, solid);
    expect_one_fan_each(solid);
}

}  // namespace snug::test
