#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "snug/samples/samples.h"
#include "snug/search/exact_cut.h"
#include "snug/search/turn.h"
#include "snug/space/available.h"

#include "tests/support/random.h"
#include "tests/support/search_designs.h"

namespace snug {
namespace {

using test::Random;

double largest_difference(const Rotation& a, const Rotation& b) {
    double worst = 0;
    for (std::size_t row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            worst = std::max(worst, std::fabs(a.row[row][column] - b.row[row][column]));
    return worst;
}

TEST(SearchTurn, AnglesOfARotationGiveTheRotationBack) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Vec3d angles{random.between(-180, 180), random.between(-90, 90), random.between(-180, 180)};
        if (random.chance(0.3)) angles.y = random.chance(0.5) ? 90 : -90;
        if (random.chance(0.3))
            angles = {90.0 * random.integer(-2, 2), angles.y, 90.0 * random.integer(-2, 2)};
        const Rotation rotation = rotation_from_euler(angles);
        EXPECT_LT(largest_difference(rotation_from_euler(euler_of(rotation)), rotation), 1e-7);
        EXPECT_LT(largest_difference(rotation_of(turn_of(rotation)), rotation), 1e-12);
    }
}

TEST(SearchTurn, ADirectionInDegreesIsThatOfTheMathematicalLibrary) {
    for (int degrees = -1800; degrees <= 1800; ++degrees) {
        const double angle = degrees / 10.0;
        const double radians = angle * 3.14159265358979323846 / 180;
        const double found = degrees_of(3 * std::sin(radians), 3 * std::cos(radians));
        EXPECT_NEAR(std::remainder(found - angle, 360), 0, 1e-10) << angle;
    }
    EXPECT_EQ(degrees_of(0, 0), 0);
}

TEST(SearchTurn, TurningTwiceIsTheProductOfTheRotations) {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const Turn a = test::random_turn(random), b = test::random_turn(random);
        const Vec3d p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const Vec3d twice = rotation_of(a)(rotation_of(b)(p)), once = rotation_of(a * b)(p);
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(twice[axis], once[axis], 1e-12);
    }
}

TEST(SearchTurn, TheSequenceComesNearEveryRotation) {
    std::vector<Turn> sequence;
    for (std::uint64_t i = 0; i < 4000; ++i) sequence.push_back(spread_turn(i, 7));
    Random random(11);
    double farthest = 1;
    for (int i = 0; i < 500; ++i) {
        const Turn target = test::random_turn(random);
        double nearest = 0;
        for (const Turn& turn : sequence) nearest = std::max(nearest, closeness(turn, target));
        farthest = std::min(farthest, nearest);
    }
    // 4,000 equal balls that fill all rotations have a radius of 15 degrees.
    EXPECT_GT(farthest, std::cos(26.0 / 2 * 3.14159265 / 180));
}

TEST(SearchTurn, PlacementsThatSymmetryCallsEqualCutEquallyManyBlocks) {
    const Mesh mesh = *sample("camera");
    const PreparedSurface surface = prepare_surface(mesh);
    for (const bool square : {false, true}) {
        const Design design = test::roomy_design(mesh, square ? Vec3d{15, 22, 22} : Vec3d{15, 15, 22});
        DesignSpace space = test::space_of(design);
        if (square) space.blocks.z = space.blocks.y;
        const BlockSymmetry symmetry(space, true);
        EXPECT_EQ(symmetry.turns().size(), square ? 8u : 4u);
        Random random(3);
        for (int i = 0; i < 20; ++i) {
            const Turn turn = test::random_turn(random);
            const Vec3d offset{random.between(-7, 7), random.between(-7, 7), random.between(-11, 11)};
            const auto first = exact_cut(surface, space, design.cut, euler_of(rotation_of(turn)), offset,
                                         all_blocks(space.blocks));
            ASSERT_TRUE(first);
            for (const Turn& equal : symmetry.turns()) {
                const auto other = exact_cut(surface, space, design.cut, euler_of(rotation_of(equal * turn)),
                                             rotation_of(equal)(offset), all_blocks(space.blocks));
                ASSERT_TRUE(other);
                EXPECT_EQ(other->cut_blocks, first->cut_blocks);
            }
        }
    }
}

TEST(SearchTurn, AQuarterTurnOfOblongBlocksIsNotAnEqual) {
    const BlockSymmetry symmetry(DesignSpace{}, true);
    const Turn quarter = turn_about({1, 0, 0}, 90);
    EXPECT_LT(symmetry.closest(quarter, Turn{}), 0.8);
    EXPECT_NEAR(symmetry.closest(turn_about({0, 1, 0}, 180), Turn{}), 1, 1e-12);
    EXPECT_EQ(BlockSymmetry(DesignSpace{}, false).turns().size(), 1u);
}

}  // namespace
}  // namespace snug
