#include "snug/polygon/ear_clipping.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "snug/polygon/polygon.h"

#include "tests/support/random.h"

namespace snug {
namespace {

using Ears = std::vector<std::array<std::size_t, 3>>;

double ear_area(const std::vector<Vec2d>& polygon, const std::array<std::size_t, 3>& ear) {
    return orientation(polygon[ear[0]], polygon[ear[1]], polygon[ear[2]]) / 2;
}

TEST(EarClipping, OnTheLatticeEveryEarHasAnAreaAndTogetherTheyAreThePolygon) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        // Towers of any width and height on one line, with corners along straight sides.
        std::vector<Vec2d> polygon{{0, 0}};
        double x = 0;
        std::vector<Vec2d> tops;
        for (int tower = random.integer(1, 30); tower > 0; --tower) {
            const double y = random.integer(1, 4), end = x + random.integer(1, 1 << 20);
            tops.insert(tops.begin(), {x, y});
            tops.insert(tops.begin(), {end, y});
            x = end;
        }
        for (double at = random.integer(1, 1 << 21); at < x; at += random.integer(1, 1 << 21))
            polygon.push_back({at, 0});
        polygon.push_back({x, 0});
        for (const Vec2d top : tops)
            if (polygon.back() != top) polygon.push_back(top);
        Ears ears;
        ASSERT_TRUE(clip_ears(polygon, -1, ears));
        ASSERT_EQ(ears.size(), polygon.size() - 2);
        double sum = 0;
        for (const auto& ear : ears) {
            ASSERT_GT(ear_area(polygon, ear), 0);
            sum += ear_area(polygon, ear);
        }
        ASSERT_EQ(sum, signed_area(polygon));
    }
}

TEST(EarClipping, APolygonThatCrossesItselfIsRefused) {
    Ears ears;
    EXPECT_FALSE(clip_ears(std::vector<Vec2d>{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 0, ears));
}

TEST(Polygon2d, AreaContentsAndOutlineOfAnL) {
    const std::vector<Vec2d> l{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    EXPECT_EQ(signed_area(l), 6);
    EXPECT_EQ(signed_area(std::vector<Vec2d>(l.rbegin(), l.rend())), -6);
    EXPECT_EQ(perimeter(l), 14);
    EXPECT_TRUE(contains(l, {0.5, 2.5}));
    EXPECT_TRUE(contains(l, {3.5, 0.5}));
    EXPECT_FALSE(contains(l, {2, 2}));
    EXPECT_FALSE(contains(l, {-1, 1}));
    EXPECT_GT(orientation({0, 0}, {1, 0}, {0, 1}), 0);
    EXPECT_EQ(orientation({0, 0}, {1, 1}, {3, 3}), 0);
}

/// The products of differences that a lattice of 32 m brings are whole numbers below 2^53.
TEST(Polygon2d, OrientationIsExactOnTheLattice) {
    const double far = 1 << 25;
    EXPECT_GT(orientation({0, 0}, {far, far - 1}, {far - 1, far - 1}), 0);
    EXPECT_EQ(orientation({0, 0}, {far, far - 1}, {2 * far, 2 * far - 2}), 0);
    EXPECT_LT(orientation({0, 0}, {far, far - 1}, {far - 1, far - 2}), 0);
}

}  // namespace
}  // namespace snug
