#include "snug/polygon/polygon_with_holes.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/polygon/polygon.h"

#include "tests/support/random.h"

namespace snug {
namespace {

VertexLoop loop_of(std::vector<std::pair<int, int>> points, std::uint32_t& next_vertex) {
    VertexLoop loop;
    for (const auto& [u, v] : points)
        loop.push_back({{static_cast<double>(u), static_cast<double>(v)}, next_vertex++});
    return loop;
}

/// Twice the area of all triangles; each must turn counter-clockwise and have an area.
std::int64_t triangulated_area(const std::vector<VertexLoop>& loops) {
    std::vector<PolygonVertex> points;
    for (const VertexLoop& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
    std::sort(points.begin(), points.end(),
              [](const PolygonVertex& a, const PolygonVertex& b) { return a.vertex < b.vertex; });
    std::vector<Triangle> triangles;
    triangulate_polygons(loops, triangles);
    return std::accumulate(triangles.begin(), triangles.end(), std::int64_t{0},
                           [&](std::int64_t sum, const Triangle& t) {
                               const PolygonVertex &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
                               const auto area = static_cast<std::int64_t>(orientation(a.at, b.at, c.at));
                               EXPECT_GT(area, 0);
                               return sum + area;
                           });
}

TEST(PolygonWithHoles, VerticesAlongStraightSidesMakeNoFlatTriangle) {
    std::uint32_t vertex = 0;
    EXPECT_EQ(triangulated_area(
                  {loop_of({{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 3}, {4, 4}, {0, 4}, {0, 1}}, vertex)}),
              32);
    EXPECT_EQ(triangulated_area({}), 0);
}

TEST(PolygonWithHoles, AHoleBetweenTheFingersOfAnotherIsReached) {
    std::uint32_t vertex = 0;
    const VertexLoop outer = loop_of({{0, 0}, {100, 0}, {100, 100}, {0, 100}}, vertex);
    // A C open to the right, clockwise, and a small square between its arms.
    const VertexLoop c =
        loop_of({{10, 10}, {10, 90}, {90, 90}, {90, 70}, {30, 70}, {30, 30}, {90, 30}, {90, 10}}, vertex);
    const VertexLoop square = loop_of({{40, 45}, {40, 55}, {50, 55}, {50, 45}}, vertex);
    const std::int64_t expected = 2 * (10000 - (80 * 80 - 60 * 40) - 100);
    EXPECT_EQ(triangulated_area({outer, c, square}), expected);
    EXPECT_EQ(triangulated_area({outer, square, c}), expected);
}

TEST(PolygonWithHoles, PiecesApartKeepTheirOwnHoles) {
    std::uint32_t vertex = 0;
    const VertexLoop left = loop_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, vertex);
    const VertexLoop hole = loop_of({{4, 4}, {4, 6}, {6, 6}, {6, 4}}, vertex);
    const VertexLoop right = loop_of({{20, 0}, {25, 0}, {25, 5}}, vertex);
    EXPECT_EQ(triangulated_area({left, hole, right}), 2 * 96 + 25);
}

/// As bores in the cut face of a part: squares apart from each other in an outline with leaning sides.
TEST(PolygonWithHoles, RandomSquareHolesInALeaningOutlineStayOpen) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        constexpr int kCell = 40000;
        std::uint32_t vertex = 0;
        const int columns = random.integer(1, 6), rows = random.integer(1, 6);
        std::vector<std::pair<int, int>> outline{{-random.integer(0, 9000), 0}};
        for (int column = 1; column < columns; ++column) outline.push_back({column * kCell, 0});
        outline.push_back({columns * kCell + random.integer(0, 9000), 0});
        for (int column = columns; column >= 0; --column) {
            const int top = rows * kCell + random.integer(0, 20000);
            outline.push_back({column * kCell, top});
            if (column > 0) outline.push_back({column * kCell - random.integer(1, kCell - 1), top});
        }
        std::vector<VertexLoop> loops{loop_of(outline, vertex)};
        std::vector<Vec2d> points;
        for (const PolygonVertex& corner : loops[0]) points.push_back(corner.at);
        auto expected = static_cast<std::int64_t>(2 * signed_area(points));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                if (random.chance(0.4)) continue;
                const int side = random.integer(100, kCell / 2),
                          u = column * kCell + random.integer(1, kCell / 2 - 1),
                          v = row * kCell + random.integer(1, kCell / 2 - 1);
                loops.push_back(
                    loop_of({{u, v}, {u, v + side}, {u + side, v + side}, {u + side, v}}, vertex));
                expected -= 2 * std::int64_t{side} * side;
            }
        EXPECT_EQ(triangulated_area(loops), expected);
    }
}

}  // namespace
}  // namespace snug
