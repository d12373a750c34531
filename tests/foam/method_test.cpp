#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "snug/depth/depth_builder.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/foam/parting.h"
#include "snug/solid/solid.h"

#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/heights.h"
#include "tests/support/random_design.h"
#include "tests/support/solid_checks.h"

// The method against its definition and against physical facts, on random soups. SNUG_CASES sets how many.

namespace snug {
namespace {

using test::Blocks;
using test::Random;
using test::RandomDesign;

BlockMap cut(const RandomDesign& design) {
    const Reach grown = reach(design.clearance, design.cut_on_touch);
    return block_map(depth_map(design.mesh, design.placement, design.space, grown), design.space, grown);
}

/// Surface that misses a block by the last tenth of a tie (depth_builder.h, kCrossingError) may count as
/// touching as well. It takes a hundred thousand snapped designs to meet one.
Blocks brute_force_of_design(const RandomDesign& design, double touch) {
    return test::brute_force_cut(test::placed_triangles(design.mesh, design.placement), design.space,
                                 {design.clearance, design.clearance, design.clearance}, design.cut_on_touch,
                                 touch);
}

TEST(Method, EveryBlockEqualsTheBruteForce) {
    long long snapped = 0, cut_blocks = 0, ties = 0;
    const int cases = test::cases(2000);
    for (int seed = 0; seed < cases; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const RandomDesign design = test::random_design(random);
        const BlockMap blocks = cut(design);
        const Blocks expected = brute_force_of_design(design, 1e-9);
        std::optional<Blocks> touched;
        snapped += design.snapped;
        for (int j = 0; j < design.space.blocks.y; ++j) {
            for (int k = 0; k < design.space.blocks.z; ++k) {
                const CutRun run = blocks(j, k);
                cut_blocks += run.blocks();
                for (int i = 0; i < design.space.blocks.x; ++i) {
                    const bool is_cut = i >= run.first && i < run.end;
                    if (is_cut == expected.cut(i, j, k)) continue;
                    if (!touched) touched = brute_force_of_design(design, 1e-9 + 2 * kCrossingError), ++ties;
                    ASSERT_TRUE(is_cut && touched->cut(i, j, k))
                        << "seed " << seed << ", block " << i << " " << j << " " << k << ", clearance "
                        << design.clearance << (design.cut_on_touch ? ", cut on touch" : "")
                        << (design.snapped ? ", snapped" : "");
                }
            }
        }
    }
    EXPECT_LE(ties, cases / 100000 + 1);
    EXPECT_GT(snapped, cases / 3);
    EXPECT_GT(cut_blocks, cases);
    RecordProperty("cases", cases);
}

TEST(Method, NoPointOfTheSurfaceLiesInFoam) {
    for (int seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 1000000);
        RandomDesign design = test::random_design(random);
        design.clearance = std::max(design.clearance, 0.01);
        const BlockMap blocks = cut(design);
        for (const auto& [a, b, c] : test::placed_triangles(design.mesh, design.placement)) {
            for (int sample = 0; sample < 20; ++sample) {
                double u = random.unit(), v = random.unit();
                if (u + v > 1) u = 1 - u, v = 1 - v;
                const Vec3d p = a + (b - a) * u + (c - a) * v;
                Vec3i block;
                bool inside = true;
                for (int axis = 0; axis < 3; ++axis) {
                    const double at = (p[axis] - design.space.face(axis, 0)) / design.space.block_mm[axis];
                    inside &= at >= 0 && at < design.space.blocks[axis];
                    block[axis] = static_cast<int>(at);
                }
                if (!inside) continue;
                const CutRun run = blocks(block.y, block.z);
                ASSERT_TRUE(block.x >= run.first && block.x < run.end);
            }
        }
    }
}

/// Foam and cut of both halves as voxels, the way a person would check with their hands.
void expect_comes_out(const Foams& foams, const BlockMap& blocks, const DesignSpace& space) {
    const test::Heights lower_half = test::lower_heights(foams),
                        upper_half = test::upper_heights(foams, space.blocks.x);
    long long lower = 0, upper = 0, cut_blocks = 0;
    for (int j = 0; j < space.blocks.y; ++j) {
        for (int k = 0; k < space.blocks.z; ++k) {
            const CutRun run = blocks(j, k);
            const int below = lower_half(j, k), above = space.blocks.x - upper_half(j, k);
            lower += below;
            upper += upper_half(j, k);
            cut_blocks += run.blocks();
            for (int i = run.first; i < run.end; ++i) {
                for (int up = i; up < space.blocks.x; ++up) ASSERT_GE(up, below) << "lower foam in the way";
                for (int down = i; down >= 0; --down) ASSERT_LT(down, above) << "upper foam in the way";
            }
        }
    }
    EXPECT_EQ(lower + upper + cut_blocks, space.block_count());
}

TEST(Method, MovingTheObjectOutNeverMeetsFoamAndNothingIsLost) {
    for (int seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 2000000);
        const RandomDesign design = test::random_design(random);
        const BlockMap blocks = cut(design);
        const int level = random.integer(0, design.space.blocks.x);
        expect_comes_out(split(blocks, design.space, level), blocks, design.space);
    }
}

TEST(Method, SolidsOfRandomDesignsAreClosedAndHoldTheirBlocks) {
    const int cases = test::cases(500);
    for (int seed = 0; seed < cases; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const RandomDesign design = test::random_design(random);
        const BlockMap blocks = cut(design);
        const int level = auto_parting_level(blocks, design.space, design.placement.bounds);
        const Foams foams = split(blocks, design.space, level);
        test::expect_solid_of(foams, Half::lower, design.space);
        test::expect_solid_of(foams, Half::lid, design.space);
    }
}

// ---- small things that a person can check on paper

DesignSpace cubes(int n, double size) {
    return {{n, n, n}, {size, size, size}};
}

Mesh box_mesh(Vec3f low, Vec3f high) {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back(
            {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

long long blocks_cut(const Mesh& mesh, const DesignSpace& space, double clearance, bool touch) {
    const Reach grown = reach(clearance, touch);
    const auto blocks = block_map(depth_map(mesh, place(mesh, {}, {}), space, grown), space, grown);
    long long count = 0;
    for (const CutRun run : blocks) count += run.blocks();
    return count;
}

TEST(Method, ASixtyMillimetrePartTakesFourBlocksOfFifteen) {
    const Mesh part = box_mesh({0, 0, 0}, {60, 60, 60});
    EXPECT_EQ(blocks_cut(part, cubes(8, 15), 0, false), 4 * 4 * 4);
    EXPECT_EQ(blocks_cut(part, cubes(8, 15), 0, true), 6 * 6 * 6);
    EXPECT_EQ(blocks_cut(part, cubes(8, 15), 1, false), 6 * 6 * 6);
    EXPECT_EQ(blocks_cut(part, cubes(8, 15), -1, false), 4 * 4 * 4);
    EXPECT_EQ(blocks_cut(box_mesh({0, 0, 0}, {31, 31, 31}), cubes(8, 15), -0.6, false), 2 * 2 * 2);
}

TEST(Method, ASheetBetweenTwoBlocksCutsNothing) {
    Mesh sheet;
    sheet.vertices = {{0, -10, -10}, {0, 10, -10}, {0, 0, 10}};
    sheet.triangles = {{0, 1, 2}};
    EXPECT_EQ(blocks_cut(sheet, cubes(4, 15), 0, false), 0);
    EXPECT_GT(blocks_cut(sheet, cubes(4, 15), 0, true), 0);
}

}  // namespace
}  // namespace snug
