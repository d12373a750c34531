#include "snug/polygon/holed_polygon.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace snug {
namespace {

PointLoop loop_of(std::vector<std::pair<int, int>> points, std::uint32_t& next_vertex) {
    PointLoop loop;
    for (const auto& [u, v] : points) loop.push_back({u, v, next_vertex++});
    return loop;
}

/// Twice the area of all triangles; each must turn counter-clockwise and have an area.
std::int64_t triangulated_area(const std::vector<PointLoop>& loops) {
    std::vector<LoopPoint> points;
    for (const PointLoop& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
    std::sort(points.begin(), points.end(),
              [](const LoopPoint& a, const LoopPoint& b) { return a.vertex < b.vertex; });
    std::vector<Triangle> triangles;
    triangulate_loops(loops, triangles);
    return std::accumulate(
        triangles.begin(), triangles.end(), std::int64_t{0}, [&](std::int64_t sum, const Triangle& t) {
            const LoopPoint &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
            const std::int64_t area = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
            EXPECT_GT(area, 0);
            return sum + area;
        });
}

TEST(HoledPolygon, VerticesAlongStraightSidesMakeNoFlatTriangle) {
    std::uint32_t vertex = 0;
    EXPECT_EQ(triangulated_area(
                  {loop_of({{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 3}, {4, 4}, {0, 4}, {0, 1}}, vertex)}),
              32);
    EXPECT_EQ(triangulated_area({}), 0);
}

TEST(HoledPolygon, AHoleBetweenTheFingersOfAnotherIsReached) {
    std::uint32_t vertex = 0;
    const PointLoop outer = loop_of({{0, 0}, {100, 0}, {100, 100}, {0, 100}}, vertex);
    // A C open to the right, clockwise, and a small square between its arms.
    const PointLoop c =
        loop_of({{10, 10}, {10, 90}, {90, 90}, {90, 70}, {30, 70}, {30, 30}, {90, 30}, {90, 10}}, vertex);
    const PointLoop square = loop_of({{40, 45}, {40, 55}, {50, 55}, {50, 45}}, vertex);
    const std::int64_t expected = 2 * (10000 - (80 * 80 - 60 * 40) - 100);
    EXPECT_EQ(triangulated_area({outer, c, square}), expected);
    EXPECT_EQ(triangulated_area({outer, square, c}), expected);
}

TEST(HoledPolygon, PiecesApartKeepTheirOwnHoles) {
    std::uint32_t vertex = 0;
    const PointLoop left = loop_of({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, vertex);
    const PointLoop hole = loop_of({{4, 4}, {4, 6}, {6, 6}, {6, 4}}, vertex);
    const PointLoop right = loop_of({{20, 0}, {25, 0}, {25, 5}}, vertex);
    EXPECT_EQ(triangulated_area({left, hole, right}), 2 * 96 + 25);
}

}  // namespace
}  // namespace snug
