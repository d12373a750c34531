#include "snug/check/bearing.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "snug/make.h"

#include "tests/support/fit_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::box_design;

TEST(Bearing, OfABoxIsItsFloorOnceItSankThroughTheGap) {
    const Mesh box = test::box_mesh({-18, -30, -20}, {18, 30, 20});  // 2 mm above and below in 10 mm blocks
    const auto object = prepare(box, box_design());
    const auto packing = pack(*object, box_design());
    const auto report =
        bearing_report(object->mesh, packing->items.front().placement, packing->space, *packing->foams);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->lower_mm2[0], 0);
    EXPECT_EQ(report->upper_mm2[0], 0);
    for (const std::size_t sunk : {1, 2}) {
        EXPECT_NEAR(report->lower_mm2[sunk], 60 * 40, 1e-6);
        EXPECT_NEAR(report->upper_mm2[sunk], 60 * 40, 1e-6);
    }
    EXPECT_NEAR(*static_pressure_kpa(2.4, 2400), 9.80665, 1e-9) << "a gram on a square millimetre";
}

TEST(Bearing, OfASphereOnFineFoamIsItsWholeShadowOnceItSankThroughOneBlock) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {1, 1, 1};
    design.space.blocks = Vec3i{120, 120, 120};
    const auto object = prepare(test::sphere_mesh(40, 200), design);
    const auto packing = pack(*object, design);
    const auto report =
        bearing_report(object->mesh, packing->items.front().placement, packing->space, *packing->foams);
    ASSERT_TRUE(report);
    const double shadow = 3.14159265 * 40 * 40;
    EXPECT_LT(report->lower_mm2[0], 0.9 * shadow) << "its flanks are steeper than a millimetre a column";
    EXPECT_GT(report->lower_mm2[2], 0.93 * shadow);
    EXPECT_LE(report->lower_mm2[2], shadow * 1.001);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(report->lower_mm2[i], report->upper_mm2[i], 0.01 * shadow);
    std::vector<Finding> findings;
    FitOptions fit;
    fit.creep_kpa = 17.2;
    find_bearing_problems(*report, *packing->foams, 1, 0.5, fit, findings);
    EXPECT_TRUE(findings.empty());
    find_bearing_problems(*report, *packing->foams, 1, 50, fit, findings);
    ASSERT_EQ(findings.size(), 2u) << "50 kg on 50 cm2";
    EXPECT_EQ(findings[0].code(), "creep");
}

}  // namespace
}  // namespace snug
