#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include "snug/make.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug::test {

/// Random designs to look at, by SNUG_CASES.
[[nodiscard]] inline int fit_cases() {
    return cases(500);
}

/// Of each half and axis, squeezed or wide, in shares of the smallest side.
[[nodiscard]] inline Clearance random_clearance(Random& random, Vec3d block_mm) {
    const double side = std::min({block_mm.x, block_mm.y, block_mm.z});
    const auto one = [&] { return random.chance(0.3) ? 0 : random.between(-0.4, 1.5) * side; };
    const Vec3d lower{one(), one(), one()};
    return {lower, random.chance(0.2) ? lower : Vec3d{one(), one(), one()}};
}

/// 12 x 20 x 20 blocks of 10 mm.
[[nodiscard]] inline Design box_design(double clearance = 0) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = Vec3i{12, 20, 20};
    design.space.block_mm = {10, 10, 10};
    design.cut.clearance_mm = clearance;
    return design;
}

[[nodiscard]] inline Packing packed(const Mesh& mesh, const Design& design) {
    const auto object = prepare(mesh, design);
    EXPECT_TRUE(object);
    auto packing = pack(*object, design);
    EXPECT_TRUE(packing && packing->foams);
    return *packing;
}

}  // namespace snug::test
