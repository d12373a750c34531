#include "bench/paper_method.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "snug/foam/block_map.h"
#include "snug/foam/depth_map.h"
#include "snug/mesh/samples.h"

#include "tests/support/random.h"

// The baseline must be an honest one: it may sample, and otherwise finds what the exact method finds.

namespace snug::bench {
namespace {

constexpr int kTexels = 512;
const Reach kReach = reach(0, false);

DesignSpace cube(int blocks, double side) {
    return {{blocks, blocks, blocks}, {side / blocks, side / blocks, side / blocks}};
}

struct Drawn {
    DepthMap sampled, exact;
    BlockMap cut_by_samples;
    long long columns = 0, equal = 0, blocks = 0, missed = 0;  ///< where something is cut
};

Drawn draw(PaperMethod& paper, const Mesh& mesh, const Placement& placement, const DesignSpace& space) {
    Drawn drawn;
    drawn.sampled = paper.depth_map(placement, space);
    drawn.exact = depth_map(mesh, placement, space, kReach);
    drawn.cut_by_samples = block_map(drawn.sampled, space, kReach);
    const BlockMap exact = block_map(drawn.exact, space, kReach);
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const CutRun a = drawn.cut_by_samples[i], b = exact[i];
        if (a.none() && b.none()) continue;
        const CutRun both{std::max(a.first, b.first), std::min(a.end, b.end)};
        drawn.columns += 1;
        drawn.equal += a == b;
        drawn.blocks += b.blocks();
        drawn.missed += b.blocks() - both.blocks();
    }
    return drawn;
}

class PaperMethodTest : public testing::Test {
  protected:
    static void SetUpTestSuite() { setenv("LP_NUM_THREADS", "0", 1); }
    const Mesh mesh = *sample("figurine");
    const double side = 1.01 * std::sqrt(dot(bounds(mesh).size(), bounds(mesh).size()));
};

TEST_F(PaperMethodTest, CutsNothingThatAnObjectGrownByATexelDoesNotReach) {
    PaperMethod paper(mesh, kTexels);
    test::Random random(1);
    for (int i = 0; i < 10; ++i) {
        SCOPED_TRACE(i);
        const int blocks = random.integer(5, 60);
        const DesignSpace space = cube(blocks, side);
        const Placement placement = place(
            mesh, {random.between(-180, 180), random.between(-180, 180), random.between(-180, 180)}, {});
        // A texel reaches over its column's side by less than its width where the columns do not divide the
        // picture.
        const Reach texel{side / kTexels};
        const BlockMap grown = block_map(depth_map(mesh, placement, space, texel), space, texel);
        const BlockMap sampled = draw(paper, mesh, placement, space).cut_by_samples;
        for (std::size_t c = 0; c < grown.size(); ++c) {
            if (sampled[c].none()) continue;
            ASSERT_GE(sampled[c].first, grown[c].first);
            ASSERT_LE(sampled[c].end, grown[c].end);
        }
    }
}

TEST_F(PaperMethodTest, CutsTheSameAsTheExactMethodInMostColumnsAndAlmostAllBlocks) {
    PaperMethod paper(mesh, kTexels);
    test::Random random(2);
    long long columns = 0, equal = 0, blocks = 0, missed = 0;
    for (int i = 0; i < 10; ++i) {
        const Placement placement = place(
            mesh, {random.between(-180, 180), random.between(-180, 180), random.between(-180, 180)}, {});
        const Drawn drawn = draw(paper, mesh, placement, cube(30, side));
        columns += drawn.columns;
        equal += drawn.equal;
        blocks += drawn.blocks;
        missed += drawn.missed;
    }
    EXPECT_GT(static_cast<double>(equal), 0.9 * static_cast<double>(columns));
    EXPECT_LT(static_cast<double>(missed), 0.02 * static_cast<double>(blocks));
}

TEST_F(PaperMethodTest, HasTheDepthsOfAFlatFaceAndNothingBesideIt) {
    // A square at x = 3, over half of the space's y and z.
    Mesh square;
    square.vertices = {{3, -4, -4}, {3, 4, -4}, {3, 4, 4}, {3, -4, 4}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    PaperMethod paper(square, kTexels);
    Placement placement;
    placement.bounds = {{3, -4, -4}, {3, 4, 4}};
    const DepthMap depths = paper.depth_map(placement, cube(16, 16));
    for (int j = 0; j < 16; ++j) {
        for (int k = 0; k < 16; ++k) {
            const bool inside = j >= 4 && j < 12 && k >= 4 && k < 12;
            ASSERT_EQ(depths(j, k).none(), !inside) << j << ' ' << k;
            if (!inside) continue;
            EXPECT_NEAR(depths(j, k).lowest, 3, 1e-5);
            EXPECT_NEAR(depths(j, k).highest, 3, 1e-5);
        }
    }
}

TEST_F(PaperMethodTest, TwoMethodsSideBySideDrawEachItsOwnObject) {
    const Mesh torus = *sample("torus");
    const DesignSpace space = cube(20, 2 * side);
    const Placement placement = place(mesh, {20, 30, 40}, {}), of_torus = place(torus, {20, 30, 40}, {});
    PaperMethod one(mesh, kTexels);
    const BlockMap alone = block_map(one.depth_map(placement, space), space, kReach);
    PaperMethod other(torus, kTexels / 2);
    const BlockMap ring = block_map(other.depth_map(of_torus, space), space, kReach);
    EXPECT_TRUE(block_map(one.depth_map(placement, space), space, kReach) == alone);
    EXPECT_TRUE(block_map(other.depth_map(of_torus, space), space, kReach) == ring);
    EXPECT_FALSE(ring == alone);
}

}  // namespace
}  // namespace snug::bench
