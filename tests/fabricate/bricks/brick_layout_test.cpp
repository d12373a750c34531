#include "snug/fabricate/bricks/brick_layout.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "snug/words/words.h"

#include "tests/support/brick_design.h"
#include "tests/support/cases.h"

namespace snug {
namespace {

using test::Random;

int cases() {
    return test::cases(300);
}

/// What stands at each plate of each stud.
using Plates = std::map<std::array<int, 3>, int>;

Plates plates_of(const BrickBuild& build) {
    Plates plates;
    for (int i = 0; i < static_cast<int>(build.bricks.size()); ++i) {
        const Brick& brick = build.bricks[static_cast<std::size_t>(i)];
        for (int row = brick.row; row < brick.row + brick.rows; ++row)
            for (int column = brick.column; column < brick.column + brick.columns; ++column)
                for (int plate = brick.bottom; plate < brick.top(); ++plate)
                    EXPECT_TRUE(plates.emplace(std::array{row, column, plate}, i).second) << "bricks overlap";
    }
    return plates;
}

void expect_filled(const BrickShape& shape, const Plates& plates) {
    std::size_t wanted = 0;
    for (int row = 0; row < shape.rows(); ++row)
        for (int column = 0; column < shape.columns(); ++column)
            for (int plate = 0; plate < shape.layers() * shape.layer_plates; ++plate)
                if (shape.has(row, column, plate / shape.layer_plates)) {
                    ++wanted;
                    EXPECT_TRUE(plates.count({row, column, plate}));
                }
    EXPECT_EQ(plates.size(), wanted);
}

void expect_each_rests_on_those_before(const BrickBuild& build, const Plates& plates) {
    for (int i = 0; i < static_cast<int>(build.bricks.size()); ++i) {
        const Brick& brick = build.bricks[static_cast<std::size_t>(i)];
        bool rests = brick.bottom == 0;
        for (int row = brick.row; row < brick.row + brick.rows; ++row)
            for (int column = brick.column; column < brick.column + brick.columns; ++column) {
                const auto below = plates.find({row, column, brick.bottom - 1});
                if (below == plates.end()) continue;
                EXPECT_LT(below->second, i) << "built before what carries it";
                rests = true;
            }
        EXPECT_TRUE(rests) << "brick " << i << " hangs in the air";
    }
}

/// By the joints as physics has them: a stud of one right below the other.
int pieces_of(const BrickBuild& build, const Plates& plates) {
    std::vector<int> parent(build.bricks.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
        return i;
    };
    for (const auto& [at, upper] : plates) {
        const auto below = plates.find({at[0], at[1], at[2] - 1});
        if (below == plates.end() || below->second == upper) continue;
        if (!build.bricks[static_cast<std::size_t>(below->second)].has_studs()) continue;
        parent[static_cast<std::size_t>(root(upper))] = root(below->second);
    }
    int count = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) count += parent[i] == static_cast<int>(i);
    return count;
}

BrickShape shape_of(const test::PrintDesign& design, Half half, BrickUnit unit = BrickUnit::plate) {
    const auto block = block_in_studs(design.space.block_mm, unit);
    return brick_shape(design.view(), half, *block,
                       unit != BrickUnit::plate && block->plates % 3 == 0 ? 3 : 1);
}

TEST(BrickLayoutTest, BricksFillTheFoamStandOnEachOtherAndHoldTogetherAsCounted) {
    for (int seed = 0; seed < cases(); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        test::PrintDesign design = test::random_brick_design(random);
        const BrickRim rim = random.chance(0.5) ? BrickRim::tiles : BrickRim::studs;
        for (const Half half : {Half::lower, Half::lid}) {
            const BrickShape shape = shape_of(design, half, BrickUnit::automatic);
            BrickBox box{BrickOptions{}};
            const auto layout = brick_layout(shape, rim, box);
            ASSERT_TRUE(layout) << text(layout.error().message);
            const Plates plates = plates_of(layout->build);
            expect_filled(shape, plates);
            expect_each_rests_on_those_before(layout->build, plates);
            EXPECT_EQ(layout->pieces, pieces_of(layout->build, plates));
            EXPECT_LE(layout->pieces, layout->pieces_at_first);
        }
    }
}

TEST(BrickLayoutTest, FoamThatACaseLeavesHangingIsSpannedOrRefused) {
    int spanned = 0, refused = 0;
    for (int seed = 0; seed < cases(); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        test::PrintDesign design = test::random_brick_design(random);
        test::round_corners(random, design);
        for (const Half half : {Half::lower, Half::lid}) {
            const BrickShape shape = shape_of(design, half);
            BrickBox box{BrickOptions{}};
            const auto layout = brick_layout(shape, BrickRim::studs, box);
            if (!layout) {
                EXPECT_NE(text(layout.error().message).find("span"), std::string::npos);
                ++refused;
                continue;
            }
            ++spanned;
            const Plates plates = plates_of(layout->build);
            expect_filled(shape, plates);
            expect_each_rests_on_those_before(layout->build, plates);
        }
    }
    EXPECT_GT(spanned, refused);
}

TEST(BrickLayoutTest, TilesCoverTheRimAndNothingElse) {
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        test::PrintDesign design = test::random_brick_design(random);
        const BrickShape shape = shape_of(design, Half::lower, BrickUnit::automatic);
        BrickBox box{BrickOptions{}};
        const auto layout = brick_layout(shape, BrickRim::tiles, box);
        ASSERT_TRUE(layout);
        Grid<char> tiled(shape.rows(), shape.columns());
        for (const Brick& brick : layout->build.bricks)
            if (brick.kind == BrickKind::tile)
                for (int row = brick.row; row < brick.row + brick.rows; ++row)
                    for (int column = brick.column; column < brick.column + brick.columns; ++column) {
                        tiled(row, column) = 1;
                        EXPECT_EQ(brick.top(), shape.top(row, column) * shape.layer_plates);
                    }
        EXPECT_EQ(tiled, shape.rim);
    }
}

TEST(BrickLayoutTest, AWallOfThreeLayersIsOnePiece) {
    const test::PrintDesign design({{3, 14, 17}, {9.6, 8, 8}}, test::filled(14, 17, 3),
                                   test::filled(14, 17, 0));
    BrickBox box{BrickOptions{}};
    const auto layout = brick_layout(shape_of(design, Half::lower, BrickUnit::brick), BrickRim::studs, box);
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->pieces, 1);
}

TEST(BrickLayoutTest, ShortBricksAreLaidAgainUntilTheyAreOnePiece) {
    // Pairs alone on two layers fall apart at first.
    BrickOptions options;
    options.family = {"1x2", "1x1"};
    const test::PrintDesign design({{3, 2, 24}, {9.6, 8, 8}}, test::filled(2, 24, 3), test::filled(2, 24, 0));
    BrickBox box{options};
    const auto layout = brick_layout(shape_of(design, Half::lower, BrickUnit::brick), BrickRim::studs, box);
    ASSERT_TRUE(layout);
    EXPECT_GT(layout->pieces_at_first, 1);
    EXPECT_EQ(layout->pieces, 1);
    EXPECT_EQ(layout->pieces, pieces_of(layout->build, plates_of(layout->build)));
}

TEST(BrickLayoutTest, TheStockIsNeverExceeded) {
    Random random(11);
    int enough = 0, missing = 0;
    for (int i = 0; i < 60; ++i) {
        test::PrintDesign design = test::random_brick_design(random);
        BrickOptions options;
        options.stock = {{"2x10", random.integer(0, 3)},
                         {"2x4", random.integer(0, 5)},
                         {"1x1", random.integer(0, 40)},
                         {"1x2", random.integer(0, 30)}};
        BrickBox box{options};
        std::map<std::string, int> used;
        bool failed = false;
        for (const Half half : {Half::lower, Half::lid}) {
            const auto layout = brick_layout(shape_of(design, half), BrickRim::studs, box);
            if (!layout) {
                EXPECT_NE(text(layout.error().message).find("stock"), std::string::npos)
                    << text(layout.error().message);
                failed = true;
                break;
            }
            for (const Brick& brick : layout->build.bricks)
                ++used[std::to_string(std::min(brick.rows, brick.columns)) + "x" +
                       std::to_string(std::max(brick.rows, brick.columns))];
        }
        ++(failed ? missing : enough);
        for (const BrickStock& stock : options.stock) EXPECT_LE(used[stock.size], stock.pieces) << stock.size;
    }
    EXPECT_GT(enough, 0);
    EXPECT_GT(missing, 0);
}

TEST(BrickLayoutTest, JointsAreThePairsThatShareStuds) {
    Random random(5);
    for (int i = 0; i < 30; ++i) {
        test::PrintDesign design = test::random_brick_design(random);
        BrickBox box{BrickOptions{}};
        const auto layout = brick_layout(shape_of(design, Half::lower), BrickRim::studs, box);
        ASSERT_TRUE(layout);
        std::map<std::pair<int, int>, int> studs;
        const Plates plates = plates_of(layout->build);
        for (const auto& [at, upper] : plates) {
            const auto below = plates.find({at[0], at[1], at[2] - 1});
            if (below != plates.end() && below->second != upper) ++studs[{below->second, upper}];
        }
        const std::vector<BrickJoint> joints = brick_joints(layout->build);
        EXPECT_EQ(joints.size(), studs.size());
        for (const BrickJoint& joint : joints)
            EXPECT_EQ(joint.rows * joint.columns, (studs[{joint.lower, joint.upper}]));
    }
}

TEST(BrickLayoutTest, FamiliesThatCannotFillAreRefusedWithWhatHelps) {
    const test::PrintDesign design({{3, 5, 5}, {9.6, 8, 8}}, test::filled(5, 5, 2), test::filled(5, 5, 1));
    BrickOptions options;
    options.family = {"2x4", "2x2"};
    BrickBox box{options};
    const auto layout = brick_layout(shape_of(design, Half::lower, BrickUnit::brick), BrickRim::studs, box);
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().kind, ErrorKind::usage);
    EXPECT_NE(text(layout.error().message).find("1x1"), std::string::npos);
}

TEST(BrickLayoutTest, BlocksThatNoBrickHasAreRefusedWithTheNearestThatWork) {
    const auto paper = block_in_studs({15, 15, 22}, BrickUnit::automatic);
    ASSERT_FALSE(paper);
    EXPECT_NE(text(paper.error().message).find("16 x 16 x 24"), std::string::npos)
        << text(paper.error().message);
    EXPECT_FALSE(block_in_studs({3.2, 8, 8}, BrickUnit::brick));
    EXPECT_FALSE(block_in_studs({9.6, 8, 9}, BrickUnit::automatic));
    const auto plates = block_in_studs({6.4, 16, 24}, BrickUnit::plate);
    ASSERT_TRUE(plates);
    EXPECT_EQ(plates->plates, 2);
    EXPECT_EQ(plates->rows, 2);
    EXPECT_EQ(plates->columns, 3);
}

}  // namespace
}  // namespace snug
