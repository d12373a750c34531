#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/solid/solid.h"

#include "tests/support/cases.h"
#include "tests/support/closedness.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace snug {
namespace {

using test::expect_sound;
using test::Random;
using test::whole_space;
using Column = Run;  // within tests Run is GoogleTest's

Column run(int first, int end) {
    return {static_cast<std::int16_t>(first), static_cast<std::int16_t>(end)};
}

Grid<Column> runs_literal(std::initializer_list<std::initializer_list<Column>> rows) {
    Grid<Column> runs(static_cast<int>(rows.size()), static_cast<int>(rows.begin()->size()));
    std::size_t column = 0;
    for (const auto& row : rows)
        for (const Column value : row) runs[column++] = value;
    return runs;
}

std::string text_of(const Grid<Column>& runs) {
    std::string text;
    for (int j = 0; j < runs.ny(); ++j) {
        for (int k = 0; k < runs.nz(); ++k)
            text += " [" + std::to_string(runs(j, k).first) + "," + std::to_string(runs(j, k).end) + ")";
        text += "\n";
    }
    return text;
}

/// As a lower half and as a lid.
void expect_sound_runs(const Grid<Column>& runs) {
    SCOPED_TRACE(text_of(runs));
    int levels = 1;
    bool any = false;
    for (const Column column : runs) {
        levels = std::max<int>(levels, column.end);
        any = any || !column.none();
    }
    for (const Half half : {Half::lower, Half::lid}) {
        const Solid solid = solid_of(runs, whole_space(runs, levels), half);
        if (any)
            expect_sound(solid, runs, levels, half);
        else
            ASSERT_TRUE(solid.vertices.empty() && solid.triangles.empty());
        if (testing::Test::HasFatalFailure()) return;
    }
}

struct RunCount {
    Grid<Column> runs;
    std::size_t vertices, triangles;
};

TEST(SolidRuns, SmallRunsHaveTheirCornersAndNoMore) {
    const Column none{};
    const RunCount cases[] = {
        {runs_literal({{run(2, 5)}}), 8, 12},
        {runs_literal({{run(3, 9), run(3, 9)}, {run(3, 9), run(3, 9)}}), 8, 12},
        // A step below, a step above, both.
        {runs_literal({{run(0, 4), run(2, 4)}}), 12, 20},
        {runs_literal({{run(1, 4), run(1, 3)}}), 12, 20},
        {runs_literal({{run(0, 4), run(1, 3)}}), 16, 28},
        // Steps the same way: two corners less than apart.
        {runs_literal({{run(0, 2), run(1, 3)}}), 16, 28},
        // Apart: above one another, in one edge, in one corner.
        {runs_literal({{run(0, 1), run(2, 3)}}), 16, 24},
        {runs_literal({{run(0, 2), run(2, 4)}}), 16, 24},
        {runs_literal({{run(0, 2), none}, {none, run(2, 4)}}), 16, 24},
        {runs_literal({{run(0, 3), none}, {none, run(1, 4)}}), 18, 28},
        // A table on four legs, and a hole below a bridge.
        {runs_literal({{run(0, 3), run(2, 3), run(0, 3)},
                       {run(2, 3), run(2, 3), run(2, 3)},
                       {run(0, 3), run(2, 3), run(0, 3)}}),
         32, 60},
        {runs_literal({{run(0, 3), run(2, 3), run(0, 3)}}), 16, 28},
    };
    for (const RunCount& c : cases) {
        SCOPED_TRACE(text_of(c.runs));
        const Solid solid = solid_of(c.runs, whole_space(c.runs, 9), Half::lower);
        EXPECT_EQ(solid.vertices.size(), c.vertices);
        EXPECT_EQ(solid.triangles.size(), c.triangles);
        expect_sound_runs(c.runs);
    }
}

/// Two tall columns meet in an edge; of the other two one joins them below and one above, so that at both
/// ends of the edge the surface could hang together.
TEST(SolidRuns, AnEdgeThatIsJoinedAtBothEndsHasTwoTrianglesASide) {
    expect_sound_runs(runs_literal({{run(0, 3), run(0, 1)}, {run(2, 3), run(0, 3)}}));
    expect_sound_runs(runs_literal({{run(0, 4), run(0, 2)}, {run(0, 4), run(2, 4)}, {run(0, 4), run(0, 4)}}));
    expect_sound_runs(runs_literal({{run(0, 4), run(0, 2), run(0, 4)}, {run(0, 4), run(2, 4), run(0, 4)}}));
}

/// The lattice's own corner: six blocks around it, or two.
TEST(SolidRuns, OppositeBlocksAroundACornerHaveVerticesOfTheirOwn) {
    expect_sound_runs(runs_literal({{run(0, 1), run(0, 0)}, {run(0, 0), run(1, 2)}}));
    expect_sound_runs(runs_literal({{run(1, 2), run(0, 2)}, {run(0, 2), run(0, 1)}}));
}

std::vector<Column> all_runs(int levels) {
    std::vector<Column> all{Column{}};
    for (int first = 0; first < levels; ++first)
        for (int end = first + 1; end <= levels; ++end) all.push_back(run(first, end));
    return all;
}

TEST(SolidRuns, EveryTwoByTwoGridIsSound) {
    const std::vector<Column> all = all_runs(3);
    const std::size_t n = all.size();
    for (std::size_t code = 0; code < n * n * n * n; ++code) {
        expect_sound_runs(runs_literal(
            {{all[code % n], all[code / n % n]}, {all[code / n / n % n], all[code / n / n / n]}}));
        if (HasFatalFailure()) return;
    }
}

/// Ways in which joined edges come from the front, from the left and from above: every 37th of the grids of
/// two levels (all of them hold, in three minutes).
TEST(SolidRuns, ThreeByThreeGridsOfTwoLevelsAreSound) {
    const std::vector<Column> all = all_runs(2);
    const int step = (1 << 18) / test::cases(7084) | 1;  // odd, so that every run stands everywhere
    for (int code = 0; code < 1 << 18; code += step) {
        Grid<Column> runs(3, 3);
        for (std::size_t i = 0; i < 9; ++i) runs[i] = all[static_cast<std::size_t>(code >> (2 * i) & 3)];
        expect_sound_runs(runs);
        if (HasFatalFailure()) return;
    }
}

enum class RunStyle { noise, checkerboard, corners, touching, lens, sparse, kCount };

Column random_run(Random& random, int levels) {
    const int a = random.integer(0, levels), b = random.integer(0, levels);
    return run(std::min(a, b), std::max(a, b));
}

Column random_column(Random& random, RunStyle style, int j, int k, int levels) {
    const int half = levels / 2;
    switch (style) {
        case RunStyle::checkerboard:  // columns that meet in edges
            return (j + k) % 2 == 0 ? random_run(random, levels) : Column{};
        case RunStyle::corners:  // blocks that meet in corners and edges
            return (j + k) % 2 == 0 ? run(0, half) : run(half, random.chance(0.8) ? levels : half);
        case RunStyle::touching:  // all runs begin or end at one level
            return random.chance(0.5) ? run(random.integer(0, half), half)
                                      : run(half, random.integer(half, levels));
        case RunStyle::lens: {
            const int miss = std::min(half, (j - 4) * (j - 4) / 8 + (k - 5) * (k - 5) / 8);
            return run(miss, levels - miss);
        }
        case RunStyle::sparse:
            return random.chance(0.2) ? random_run(random, levels) : Column{};
        default:
            return random_run(random, levels);
    }
}

Grid<Column> random_runs(Random& random, int longest) {
    const auto style = static_cast<RunStyle>(random.integer(0, static_cast<int>(RunStyle::kCount) - 1));
    const int levels = random.integer(1, 6);
    Grid<Column> runs(random.integer(1, longest), random.integer(1, longest));
    for (int j = 0; j < runs.ny(); ++j)
        for (int k = 0; k < runs.nz(); ++k) runs(j, k) = random_column(random, style, j, k, levels);
    return runs;
}

TEST(SolidRuns, RandomRunsAreClosedAndExact) {
    const auto seeds = static_cast<std::uint64_t>(test::cases(2000));
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        expect_sound_runs(random_runs(random, seed % 50 == 0 ? 40 : seed % 3 == 0 ? 3 : 10));
        if (HasFatalFailure()) return;
    }
}

TEST(SolidRuns, ALargeNoisyGridIsSound) {
    Random random(7);
    Grid<Column> runs(300, 180);
    double blocks = 0;
    for (Column& column : runs) blocks += (column = random_run(random, 4)).blocks();
    const Solid solid = solid_of(runs, whole_space(runs, 4), Half::lower);
    EXPECT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
    EXPECT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
    EXPECT_EQ(test::signed_volume(solid.vertices, solid.triangles), 8 * blocks);
}

}  // namespace
}  // namespace snug
