#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "snug/mesh/raw_mesh.h"

#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

/// Cuts a polygon in the plane z = 0 and gives the sums of its triangles' areas, with and without the way
/// they are wound: equal to the polygon's own area where they cover its inside once and nothing else.
struct Cover {
    double wound = 0, all = 0;
    std::size_t triangles = 0;
};

Cover cover(const std::vector<Vec3d>& outline, Vec3d shear = {}) {
    RawMesh raw;
    std::vector<std::uint32_t> corners;
    for (const Vec3d& p : outline) {
        corners.push_back(static_cast<std::uint32_t>(raw.vertices.size()));
        raw.vertices.push_back({p.x, p.y, shear.x * p.x + shear.y * p.y + shear.z});
    }
    append_polygon(raw, corners);
    Cover sums;
    sums.triangles = raw.triangles.size();
    for (const auto& [a, b, c] : raw.triangles) {
        const double area =
            0.5 * cross(raw.vertices[b] - raw.vertices[a], raw.vertices[c] - raw.vertices[a]).z;
        sums.wound += area;
        sums.all += std::fabs(area);
    }
    return sums;
}

double area_of(const std::vector<Vec3d>& outline) {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec3d p = outline[i], q = outline[(i + 1) % outline.size()];
        sum += 0.5 * (p.x * q.y - p.y * q.x);
    }
    return sum;
}

void expect_covered_once(const std::vector<Vec3d>& outline, Vec3d shear = {}) {
    const Cover sums = cover(outline, shear);
    EXPECT_EQ(sums.triangles, outline.size() - 2);
    EXPECT_NEAR(sums.wound, area_of(outline), 1e-9 * std::fabs(area_of(outline)));
    EXPECT_NEAR(sums.all, std::fabs(area_of(outline)), 1e-9 * std::fabs(area_of(outline)));
}

/// A comb with `teeth` teeth: a fan would cover the gaps between them.
std::vector<Vec3d> comb(int teeth) {
    std::vector<Vec3d> outline{{2.0 * teeth, 0, 0}, {2.0 * teeth, 1, 0}};
    for (int tooth = teeth - 1; tooth >= 0; --tooth) {
        outline.push_back({2.0 * tooth + 1.5, 5, 0});
        outline.push_back({2.0 * tooth, 1, 0});
    }
    outline.push_back({0, 0, 0});
    return outline;
}

TEST(Polygon, OfUpToAThousandCornersIsCutInsideItsOutline) {
    for (const int teeth : {1, 2, 10, 31, 40, 100, 400, 498}) {
        SCOPED_TRACE(teeth);
        expect_covered_once(comb(teeth));
        expect_covered_once(comb(teeth), {0.4, -3, 7});
        std::vector<Vec3d> reversed = comb(teeth);
        std::reverse(reversed.begin(), reversed.end());
        expect_covered_once(reversed);
        std::rotate(reversed.begin(), reversed.begin() + 2, reversed.end());
        expect_covered_once(reversed);
    }
}

TEST(Polygon, SpiralsAreCutInsideTheirOutline) {
    for (const int half : {10, 100, 480}) {
        SCOPED_TRACE(half);
        std::vector<Vec3d> outline;
        for (int side = 0; side < 2; ++side) {
            for (int step = 0; step < half; ++step) {
                const double t = 0.2 * (side == 0 ? step : half - 1 - step),
                             radius = t + (side == 0 ? 1 : 0.5);
                outline.push_back({radius * std::cos(t), radius * std::sin(t), 0});
            }
        }
        expect_covered_once(outline);
    }
}

TEST(Polygon, CornersOnStraightEdgesAndCornersGivenTwiceDoNotSpoilTheCut) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const std::vector<Vec3d> plain = comb(random.integer(1, 20));
        std::vector<Vec3d> outline;
        for (std::size_t i = 0; i < plain.size(); ++i) {
            const Vec3d p = plain[i], q = plain[(i + 1) % plain.size()];
            for (int times = random.integer(1, 2); times > 0; --times) outline.push_back(p);
            // Points that rounding puts a hair beside the edge.
            for (int point = 1; point <= random.integer(0, 3); ++point)
                outline.push_back(p + (q - p) * (point / 7.0));
        }
        expect_covered_once(outline, {0.3, 0.7, 0});
    }
}

TEST(Polygon, AHoleThatABridgeJoinsToTheOutlineStaysOpen) {
    expect_covered_once({{0, 0, 0},
                         {9, 0, 0},
                         {9, 9, 0},
                         {0, 9, 0},
                         {0, 0, 0},
                         {3, 3, 0},
                         {3, 6, 0},
                         {6, 6, 0},
                         {6, 3, 0},
                         {3, 3, 0}});
}

TEST(Polygon, TriangleCountAndWindingHoldForCrossedAndFlatOnes) {
    for (int seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        std::vector<Vec3d> outline;
        const int n = random.integer(3, seed % 10 == 0 ? 1300 : 30);
        for (int i = 0; i < n; ++i)
            outline.push_back({random.between(0, 1), seed % 3 == 0 ? 0.5 : random.between(0, 1), 0});
        const Cover sums = cover(outline);
        EXPECT_EQ(sums.triangles, outline.size() - 2);
        EXPECT_NEAR(sums.wound, area_of(outline), 1e-9);
    }
}

TEST(Polygon, OfAnyShapeKeepsItsArea) {
    for (int seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        // A star-shaped polygon in a tilted plane.
        RawMesh raw;
        std::vector<std::uint32_t> corners;
        const int n = random.integer(4, 40);
        double expected = 0;
        std::vector<Vec3d> flat;
        for (int i = 0; i < n; ++i) {
            const double angle = 6.283185307179586 * (i + random.between(0, 0.8)) / n,
                         radius = random.between(0.2, 1);
            flat.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
            corners.push_back(static_cast<std::uint32_t>(i));
        }
        for (int i = 0; i < n; ++i) {
            const Vec3d p = flat[static_cast<std::size_t>(i)],
                        q = flat[static_cast<std::size_t>((i + 1) % n)];
            expected += 0.5 * (p.x * q.y - p.y * q.x);
            raw.vertices.push_back({p.x + 0.3 * p.y, p.y, p.x - p.y});
        }
        append_polygon(raw, corners);
        ASSERT_EQ(raw.triangles.size(), corners.size() - 2);
        double covered = 0;
        for (const auto& [a, b, c] : raw.triangles) {
            const Vec3d normal = cross(raw.vertices[b] - raw.vertices[a], raw.vertices[c] - raw.vertices[a]);
            EXPECT_GE(normal.z, -1e-12);
            covered += 0.5 * normal.z;
        }
        EXPECT_NEAR(covered, expected, 1e-9);
    }
}

}  // namespace
}  // namespace snug
