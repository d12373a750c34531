#include "snug/solid/solid.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/support/closedness.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using Heights = Grid<std::uint16_t>;
using Lattice = std::tuple<int, int, int>;  ///< level, J, K

/// Blocks of 2 mm, so that every lattice point has whole coordinates.
DesignSpace whole_space(const Heights& heights, int levels) {
    return {{levels, heights.ny(), heights.nz()}, {2, 2, 2}};
}

FoamPair pair_of(const Heights& heights) {
    return {heights, heights, 0};
}

Heights literal(std::initializer_list<std::initializer_list<int>> rows) {
    Heights heights(static_cast<int>(rows.size()), static_cast<int>(rows.begin()->size()));
    int j = 0;
    for (const auto& row : rows) {
        int k = 0;
        for (const int height : row) heights(j, k++) = static_cast<std::uint16_t>(height);
        ++j;
    }
    return heights;
}

/// The solid as an array of blocks, for tests alone, with everything that can be read off one.
struct Voxels {
    Vec3i n;
    std::vector<char> solid;

    Voxels(const Heights& heights, int levels)
        : n{levels, heights.ny(), heights.nz()}, solid(static_cast<std::size_t>(n.x) * n.y * n.z) {
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k)
                for (int i = 0; i < heights(j, k); ++i) solid[index(i, j, k)] = 1;
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

void expect_sound(const Solid& solid, const Heights& heights, int levels, bool upper) {
    const DesignSpace space = whole_space(heights, levels);
    const Voxels voxels(heights, levels);
    const std::vector<Vec3i> points = lattice_points(solid, space, upper);
    ASSERT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
    ASSERT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
    ASSERT_EQ(test::signed_volume(solid.vertices, solid.triangles),
              8.0 * static_cast<double>(voxels.blocks()));
    std::set<Lattice> standing;
    for (const Vec3i p : points) standing.insert({p.x, p.y, p.z});
    ASSERT_EQ(standing, voxels.corners());
    expect_faces_as_shown(points, solid, voxels, upper);
    expect_no_vertex_inside_an_edge(points, solid);
    expect_one_fan_each(solid);
}

void expect_sound(const Heights& heights) {
    const int highest = *std::max_element(heights.begin(), heights.end());
    const int levels = highest + 1;
    const Solid lower = lower_solid(pair_of(heights), whole_space(heights, levels));
    const Solid upper = upper_solid(pair_of(heights), whole_space(heights, levels));
    if (highest == 0) {
        ASSERT_TRUE(lower.vertices.empty() && lower.triangles.empty());
        ASSERT_TRUE(upper.vertices.empty() && upper.triangles.empty());
        return;
    }
    expect_sound(lower, heights, levels, false);
    expect_sound(upper, heights, levels, true);
}

struct Count {
    Heights heights;
    std::size_t vertices, triangles;
};

TEST(Solid, SmallHeightFieldsHaveTheirCornersAndNoMore) {
    const Count cases[] = {
        {literal({{0, 0}, {0, 0}}), 0, 0},
        {literal({{1}}), 8, 12},
        {literal({{7, 7, 7}, {7, 7, 7}}), 8, 12},
        {literal({{0, 0, 0}, {0, 3, 0}, {0, 0, 0}}), 8, 12},
        {literal({{2, 0}, {2, 2}}), 12, 20},
        {literal({{1, 2}}), 12, 20},
        {literal({{2, 1}, {1, 2}}), 19, 34},
        {literal({{2, 0}, {0, 2}}), 16, 24},
        {literal({{3, 0}, {0, 2}}), 17, 26},
        {literal({{2, 2, 2}, {2, 1, 2}, {2, 2, 2}}), 16, 28},
        {literal({{2, 2, 2}, {2, 0, 2}, {2, 2, 2}}), 16, 32},
        {literal({{2, 2, 2}, {2, 3, 2}, {2, 2, 2}}), 16, 28},
    };
    for (const Count& c : cases) {
        SCOPED_TRACE(::testing::PrintToString(std::vector<int>(c.heights.begin(), c.heights.end())));
        const Solid solid = lower_solid(pair_of(c.heights), whole_space(c.heights, 8));
        EXPECT_EQ(solid.vertices.size(), c.vertices);
        EXPECT_EQ(solid.triangles.size(), c.triangles);
        expect_sound(c.heights);
    }
}

TEST(Solid, HalvesMeetInTheSamePlane) {
    // Lower 2 of 5 blocks, upper 1 of 5: the space in between is cut away.
    const DesignSpace space{{5, 1, 1}, {10, 3, 4}};
    const FoamPair foams{Heights(1, 1, 2), Heights(1, 1, 1), 2};
    const auto range = [](const Solid& solid) {
        float low = 1e9f, high = -1e9f;
        for (const Vec3f v : solid.vertices) {
            low = std::min(low, v.x);
            high = std::max(high, v.x);
            EXPECT_EQ(std::fabs(v.y), 1.5f);
            EXPECT_EQ(std::fabs(v.z), 2.0f);
        }
        return std::pair(low, high);
    };
    EXPECT_EQ(range(lower_solid(foams, space)), std::pair(-25.0f, -5.0f));
    EXPECT_EQ(range(upper_solid(foams, space)), std::pair(15.0f, 25.0f));
}

TEST(Solid, CoordinatesAreTheBlockFacesOfTheSpace) {
    const DesignSpace space{{4096, 2, 3}, {0.1, 12.7, 9.6}};
    Heights heights(2, 3, 4095);
    heights(1, 1) = 4096;
    heights(0, 2) = 0;
    const Solid solid = upper_solid({heights, heights, 0}, space);
    for (const Vec3f v : solid.vertices) {
        bool found[3] = {};
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i <= space.blocks[axis]; ++i)
                found[axis] |= v[axis] == static_cast<float>(space.face(axis, i));
        ASSERT_TRUE(found[0] && found[1] && found[2]);
    }
    EXPECT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
    const double volume = (4.0 * 4095 + 4096) * space.block_volume();
    EXPECT_NEAR(test::signed_volume(solid.vertices, solid.triangles), volume, volume * 1e-6);
}

TEST(Solid, RoundingToFloatsKeepsCornersApart) {
    for (const double size : {0.1, 0.3, 12.7, 25.4, 9999.9, 10000.0}) {
        const DesignSpace space{{4096, 4095, 1}, {size, size, size}};
        for (int axis = 0; axis < 2; ++axis)
            for (int i = 0; i < space.blocks[axis]; ++i)
                ASSERT_LT(static_cast<float>(space.face(axis, i)),
                          static_cast<float>(space.face(axis, i + 1)));
    }
}

enum class Style { noise, smooth, sparse, pinches, plateaus, kCount };

Heights random_heights(test::Random& random, Style style, int ny, int nz) {
    Heights heights(ny, nz);
    const double a = random.between(0.05, 0.6), b = random.between(0.05, 0.6);
    const int top = random.integer(1, 6);
    for (int j = 0; j < ny; ++j) {
        for (int k = 0; k < nz; ++k) {
            int height = 0;
            switch (style) {
                case Style::noise:
                    height = random.integer(0, 3);
                    break;
                case Style::smooth:
                    height = static_cast<int>(4 + 2 * std::sin(a * j) + 2 * std::cos(b * k));
                    break;
                case Style::sparse:
                    height = random.chance(0.15) ? random.integer(1, top) : 0;
                    break;
                case Style::pinches:
                    height = (j + k) % 2 == 0 ? random.integer(1, 3) : random.integer(0, 1);
                    break;
                default:
                    height = top - (random.chance(0.1) ? random.integer(1, top) : 0);
                    break;
            }
            heights(j, k) = static_cast<std::uint16_t>(height);
        }
    }
    return heights;
}

TEST(Solid, RandomSolidsAreClosedAndExact) {
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const int longest = seed % 50 == 0 ? 40 : seed % 3 == 0 ? 3 : 10;
        const auto style = static_cast<Style>(random.integer(0, static_cast<int>(Style::kCount) - 1));
        expect_sound(random_heights(random, style, random.integer(1, longest), random.integer(1, longest)));
        if (HasFatalFailure()) return;
    }
}

TEST(Solid, EveryTwoByTwoFieldIsSound) {
    for (int code = 0; code < 625; ++code) {
        SCOPED_TRACE(code);
        expect_sound(literal({{code % 5, code / 5 % 5}, {code / 25 % 5, code / 125}}));
        if (HasFatalFailure()) return;
    }
}

TEST(Solid, ALargeNoisyFieldIsSound) {
    test::Random random(7);
    Heights heights(300, 180);
    for (auto& height : heights) height = static_cast<std::uint16_t>(random.integer(0, 3));
    const DesignSpace space = whole_space(heights, 4);
    const Solid solid = lower_solid(pair_of(heights), space);
    EXPECT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
    EXPECT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
    const double blocks = std::accumulate(heights.begin(), heights.end(), 0.0);
    EXPECT_EQ(test::signed_volume(solid.vertices, solid.triangles), 8 * blocks);
}

}  // namespace
}  // namespace snug
