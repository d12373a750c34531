#include "snug/check/stability.h"

#include <cmath>

#include <gtest/gtest.h>

#include "snug/make.h"

#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;

constexpr double kDegree = 3.14159265358979323846 / 180;

Object box_object(Vec3d size, const Design& design) {
    return prepare(test::box_mesh(size * -0.5, size * 0.5), design).value();
}

TEST(Stability, ABoxTipsWhereItsMiddleLeavesItsPocket) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks.reset();
    design.space.block_mm = {1, 1, 1};
    design.space.open = 0.25;
    const Object box = box_object({80, 40, 60}, design);
    const Packing packing = pack(box, checked(design).value()).value();
    ASSERT_TRUE(packing.items.front().tip_deg);
    // Sunk 20 of 80 mm, its middle stands 20 mm above the rim, which is 40 mm wide.
    EXPECT_NEAR(*packing.items.front().tip_deg, 45, 1.5);
    design.space.open = 0.5;
    EXPECT_FALSE(pack(box, checked(design).value()).value().items.front().tip_deg)
        << "its middle is at the rim";
    const Object tower = box_object({300, 20, 20}, design);
    design.space.open = 0.1;
    const Packing leaning = pack(tower, checked(design).value()).value();
    EXPECT_LT(*leaning.items.front().tip_deg, 6);
    EXPECT_TRUE(std::any_of(leaning.findings.begin(), leaning.findings.end(),
                            [](const Finding& finding) { return finding.code() == "tips_out"; }));
}

TEST(Stability, TheAngleIsTheLeastOfAllDirections) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 4400);
        const DesignSpace space{{20, random.integer(1, 9), random.integer(1, 9)}, {2, 7, 5}};
        BlockMap cut(space.blocks.y, space.blocks.z);
        const int level = random.integer(1, 20);
        std::vector<Vec3d> corners;
        for (int j = 0; j < cut.ny(); ++j)
            for (int k = 0; k < cut.nz(); ++k) {
                if (random.chance(0.6)) continue;
                const int first = random.integer(0, 19);
                cut(j, k) = {static_cast<std::int16_t>(first), 20};
                if (first >= level) continue;
                for (const int row : {j, j + 1})
                    for (const int column : {k, k + 1})
                        corners.push_back({0, space.face(1, row), space.face(2, column)});
            }
        const Vec3d centre{random.between(-25, 25), random.between(-10, 10), random.between(-10, 10)};
        const auto angle = tip_angle_deg(cut, space, level, centre);
        const double above = centre.x - space.face(0, level);
        ASSERT_EQ(angle.has_value(), above > 0);
        if (!angle) continue;
        double least = corners.empty() ? 0 : 90;
        for (double way = 0; way < 360 && !corners.empty(); way += 0.05) {
            double reach = -1e9;
            for (const Vec3d& corner : corners)
                reach = std::max(reach, (corner.y - centre.y) * std::cos(way * kDegree) +
                                            (corner.z - centre.z) * std::sin(way * kDegree));
            least = std::min(least, std::atan2(std::max(0.0, reach), above) / kDegree);
        }
        EXPECT_NEAR(*angle, least, 0.1);
    }
}

TEST(Stability, TheCentreOfAClosedObjectIsThatOfItsVolume) {
    Design design;
    design.object.units = Unit::mm;
    Mesh two = test::box_mesh({0, 0, 0}, {10, 10, 10});
    const Mesh large = test::box_mesh({20, 0, 0}, {40, 20, 20});
    for (const Triangle& t : large.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    two.vertices.insert(two.vertices.end(), large.vertices.begin(), large.vertices.end());
    const MeshMeasure measured = measure(two);
    ASSERT_TRUE(measured.centre);
    EXPECT_NEAR(measured.centre->x, (1000 * 5 + 8000 * 30) / 9000.0, 1e-4);
    EXPECT_NEAR(measured.centre->y, (1000 * 5 + 8000 * 10) / 9000.0, 1e-4);
    two.triangles.pop_back();
    EXPECT_FALSE(measure(two).centre);
}

}  // namespace
}  // namespace snug
