#include "snug/solid/solid.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>

#include <gtest/gtest.h>

#include "snug/space/available.h"

#include "tests/support/closedness.h"
#include "tests/support/heights.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace snug {
namespace {

using Heights = Grid<std::uint16_t>;
using test::expect_sound;
using test::whole_space;

Grid<Run> from_the_ground(const Heights& heights) {
    Grid<Run> runs(heights.ny(), heights.nz());
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].end = static_cast<std::int16_t>(heights[i]);
    return runs;
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

void expect_sound(const Heights& heights) {
    const int highest = *std::max_element(heights.begin(), heights.end());
    const int levels = highest + 1;
    const Grid<Run> runs = from_the_ground(heights);
    const Solid lower = solid_of(runs, whole_space(runs, levels), Half::lower);
    const Solid upper = solid_of(runs, whole_space(runs, levels), Half::lid);
    if (highest == 0) {
        ASSERT_TRUE(lower.vertices.empty() && lower.triangles.empty());
        ASSERT_TRUE(upper.vertices.empty() && upper.triangles.empty());
        return;
    }
    expect_sound(lower, runs, levels, Half::lower);
    expect_sound(upper, runs, levels, Half::lid);
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
        const Solid solid =
            solid_of(from_the_ground(c.heights), whole_space(from_the_ground(c.heights), 8), Half::lower);
        EXPECT_EQ(solid.vertices.size(), c.vertices);
        EXPECT_EQ(solid.triangles.size(), c.triangles);
        expect_sound(c.heights);
    }
}

TEST(Solid, HalvesMeetInTheSamePlane) {
    // Lower 2 of 5 blocks, upper 1 of 5: the space in between is cut away.
    const DesignSpace space{{5, 1, 1}, {10, 3, 4}};
    const Foams foams = test::foams_of_heights(test::filled(1, 1, 2), test::filled(1, 1, 1), 2, 5);
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
    const Solid solid = solid_of(from_the_ground(heights), space, Half::lid);
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
    const DesignSpace space = whole_space(from_the_ground(heights), 4);
    const Solid solid = solid_of(from_the_ground(heights), space, Half::lower);
    EXPECT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
    EXPECT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
    const double blocks = std::accumulate(heights.begin(), heights.end(), 0.0);
    EXPECT_EQ(test::signed_volume(solid.vertices, solid.triangles), 8 * blocks);
}

}  // namespace
}  // namespace snug
