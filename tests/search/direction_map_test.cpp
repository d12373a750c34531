#include "snug/search/direction_map.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/samples/samples.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

/// A few quick looks are enough: what each of them names must be true.
DirectionMap looked_at(const Object& object, const Design& design, const Packing& packing) {
    DirectionMap map(object.mesh, *object.prepared, design, packing.space, 40, packing.available);
    while (map.passes() < 2) map.step();
    return map;
}

Object packed(const std::string& name, const Design& design) {
    auto object = prepare(*sample(name), design);
    prepare_for_many(*object);
    return std::move(*object);
}

/// Takes each placement into the design, as the studio does.
void expect_as_named(const Object& object, Design design, const std::string& what) {
    const auto packing = pack(object, design);
    ASSERT_TRUE(packing) << what;
    const DirectionMap map = looked_at(object, design, *packing);
    const Walls wanted = wanted_wall_mm(design.space);
    int fitting = 0;
    for (const DirectionCut& cut : map.cuts()) {
        if (cut.cut_blocks < 0) continue;
        ++fitting;
        EXPECT_NEAR(std::fabs(rotation_from_euler(cut.rotation_deg)(cut.direction).x), 1, 1e-9) << what;
        design.placement = {cut.rotation_deg, cut.offset_mm};
        const auto taken = pack(object, design);
        ASSERT_TRUE(taken) << what;
        ASSERT_TRUE(taken->foams) << what;
        EXPECT_EQ(taken->fit.cut_blocks, cut.cut_blocks) << what;
        for (std::size_t side = 0; side < 6; ++side)
            EXPECT_GE(taken->fit.wall_mm[side], wanted[side]) << what;
    }
    EXPECT_GT(fitting, 10) << what;
}

TEST(DirectionMap, WhatIsTakenFromItCutsWhatItNamesAndKeepsTheWalls) {
    const std::uint64_t seed = 20240611;
    test::Random random(seed);
    int left = test::cases_at_most(2);
    for (const char* name : {"camera", "figurine"}) {
        if (left-- <= 0) return;
        Design design;
        design.object.units = Unit::mm;
        const Object object = packed(name, design);
        const std::string what = std::string(name) + ", seed " + std::to_string(seed);
        expect_as_named(object, design, what + ", as many blocks as chosen");
        design.space.blocks.reset();
        expect_as_named(object, design, what + ", fitted");
        design.space.wall_mm = Walls{20, 45, 31, 50, 12, 70};
        const auto mm = [&] { return random.between(-2, 6); };
        design.cut.clearance_mm = Clearance({mm(), mm(), mm()}, {mm(), mm(), mm()});
        expect_as_named(object, design, what + ", fitted, six walls and clearances");
        design.space.blocks = pack(object, design)->space.blocks + Vec3i{6, 6, 6};
        expect_as_named(object, design, what + ", chosen blocks, six walls and clearances");
    }
}

}  // namespace
}  // namespace snug
