#include "snug/fabricate/kit/finger_room.h"

#include <utility>

#include <gtest/gtest.h>

#include "tests/support/cut_foams.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::CutFoams;
using test::foams_of;

/// A box of 40 x 40 x 40 mm that lies nearer to the front and the left of a larger cavity.
TEST(FingerRoomTest, IsTheWayFromTheFoamToTheObject) {
    const Mesh mesh = test::box_mesh({-20, -20, -20}, {20, 20, 20});
    const DesignSpace space{{12, 12, 12}, {10, 10, 10}};
    BlockMap blocks(12, 12);
    for (int j = 1; j < 9; ++j)
        for (int k = 3; k < 11; ++k) blocks(j, k) = {2, 10};
    const CutFoams foams = foams_of(space, std::move(blocks), 6);
    const auto room =
        finger_room(mesh, place(mesh, {}, {}), space, foams.blocks, foams.foams.piece(Half::lower), 6);
    // The cavity reaches from y = -50 to 30 and from z = -30 to 50.
    const double expected[] = {30, 10, 10, 30};  // back, front, left, right
    for (int side = 0; side < 4; ++side) {
        EXPECT_LE(room[side].mm, expected[side] + 1e-9) << side;
        EXPECT_GE(room[side].mm, expected[side] - 2 - 1e-9) << "a cell of the measuring grid less at most";
    }
    EXPECT_NEAR(room[0].where.y, -35, 2);
    EXPECT_NEAR(room[3].where.z, 35, 2);
}

TEST(FingerRoomTest, AShallowLedgeIsNoRoom) {
    const Mesh mesh = test::box_mesh({-20, -20, -20}, {20, 20, 20});
    const DesignSpace space{{12, 12, 12}, {10, 10, 10}};
    BlockMap blocks(12, 12);
    for (int j = 0; j < 12; ++j)
        for (int k = 0; k < 12; ++k) blocks(j, k) = {5, 7};  // one block below the parting
    for (int j = 4; j < 8; ++j)
        for (int k = 4; k < 8; ++k) blocks(j, k) = {4, 8};
    const CutFoams foams = foams_of(space, std::move(blocks), 6);
    for (const FingerRoom& room :
         finger_room(mesh, place(mesh, {}, {}), space, foams.blocks, foams.foams.piece(Half::lower), 6))
        EXPECT_EQ(room.mm, 0);
}

}  // namespace
}  // namespace snug
