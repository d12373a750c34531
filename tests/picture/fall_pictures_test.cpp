#include "snug/picture/fall_pictures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace snug {
namespace {

struct Extent {
    Vec2d least{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    Vec2d most{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
};

Extent extent_of(const std::vector<Loop>& loops) {
    Extent extent;
    for (const Loop& loop : loops)
        for (const Vec2d point : loop) {
            extent.least = {std::min(extent.least.x, point.x), std::min(extent.least.y, point.y)};
            extent.most = {std::max(extent.most.x, point.x), std::max(extent.most.y, point.y)};
        }
    return extent;
}

/// Two pieces that part at 4 of 10 blocks of 10 mm, and a box that lies near the floor, the back and the
/// left.
std::vector<FallPicture> pictures() {
    const DesignSpace space{{10, 20, 30}, {10, 10, 10}};
    Foams foams;
    foams.pieces = {Grid<Run>(20, 30, Run{0, 4}), Grid<Run>(20, 30, Run{4, 10})};
    foams.parting = {4};
    const Mesh mesh = test::box_mesh({-5, -10, -20}, {5, 10, 20});
    const Placement placement = place(mesh, {}, {-40, -80, -120});
    const FallingMesh falling{mesh, placement};
    return fall_pictures(foams, space, std::span(&falling, 1));
}

}  // namespace

TEST(FallPictures, TheSideThatItFallsOnLiesBelow) {
    const std::vector<FallPicture> all = pictures();
    ASSERT_EQ(all.size(), 6u);
    const std::array<double, 6> heights{100, 100, 200, 200, 300, 300};
    const std::array<double, 6> widths{300, 300, 100, 100, 100, 100};
    for (std::size_t side = 0; side < 6; ++side) {
        const FallPicture& picture = all[side];
        EXPECT_EQ(picture.face, static_cast<Side>(side));
        EXPECT_EQ(picture.size.x, widths[side]) << side;
        EXPECT_EQ(picture.size.y, heights[side]) << side;
        const Extent item = extent_of(picture.items);
        // It lies at the low end of every axis: below in a fall onto the low side, above onto the high one.
        const double middle = (item.least.y + item.most.y) / 2;
        EXPECT_EQ(middle > 0, side % 2 == 0) << side;
    }
}

TEST(FallPictures, ThePiecesFillTheCaseWhateverSideIsBelow) {
    for (const FallPicture& picture : pictures()) {
        ASSERT_EQ(picture.foams.size(), 2u);
        const Extent lower = extent_of({picture.foams[0].outline}),
                     lid = extent_of({picture.foams[1].outline});
        const auto area = [](const Extent& e) { return (e.most.x - e.least.x) * (e.most.y - e.least.y); };
        EXPECT_NEAR(area(lower) + area(lid), picture.size.x * picture.size.y, 1e-6);
        EXPECT_NEAR(area(lower) / area(lid), 4.0 / 6, 1e-9);
        if (picture.face == kFloor) {
            EXPECT_GT(lower.most.y, lid.most.y);
        }
        if (picture.face == kRoof) {
            EXPECT_LT(lower.most.y, lid.most.y);
        }
    }
}

TEST(FallPictures, EveryShapeStaysInItsRectangle) {
    const std::vector<FallPicture> all = pictures();
    const Vec2d size{60, 50};
    const double scale = fall_scale(all, size);
    for (const FallPicture& picture : all)
        for (const FallShape& shape : fall_shapes(picture, scale, size)) {
            const Extent extent = extent_of(shape.loops);
            EXPECT_GE(extent.least.x, -1e-9);
            EXPECT_GE(extent.least.y, -1e-9);
            EXPECT_LE(extent.most.x, size.x + 1e-9);
            EXPECT_LE(extent.most.y, size.y + 1e-9);
        }
}

}  // namespace snug
