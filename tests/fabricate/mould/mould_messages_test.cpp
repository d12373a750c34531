#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "snug/base/rotation.h"
#include "snug/fabricate/mould/mould.h"
#include "snug/words/words.h"

#include "tests/support/print_design.h"

// What the moulds' pack says: figures, findings, and why it refuses.

namespace snug {
namespace {

using test::Heights;

TEST(MouldPack, SaysHowMuchToPourAndWhatTheDraftTakes) {
    const test::PrintDesign design({{4, 8, 8}, {10, 10, 10}}, test::filled(8, 8, 2), test::filled(8, 8, 2));
    WorkshopOptions options;
    options.mould.draft_deg = 0;
    EXPECT_NEAR(*mould_pack(design.view(), options)->material.litres, 2 * 0.128, 1e-6);
    options.mould.draft_deg = 10;
    const auto pack = mould_pack(design.view(), options);
    // Two frusta of 80 mm at the pour level, 20 mm deep.
    const SineCosine lean = sine_cosine_degrees(10);
    const double foot = 80 - 2 * 20 * lean.sine / lean.cosine;
    EXPECT_NEAR(*pack->material.litres, 2 * 20 / 3.0 * (80 * 80 + foot * foot + 80 * foot) * 1e-6, 1e-5);
    ASSERT_EQ(pack->findings.size(), 1u);
    EXPECT_EQ(pack->findings[0].code(), "draft");
    EXPECT_NE(text(pack->findings[0].message).find("3.5 mm on each side"), std::string::npos)
        << text(pack->findings[0].message);
}

TEST(MouldPack, FoamTooNarrowForTheDraftIsAWarning) {
    Heights lower = test::filled(5, 9, 10);
    for (int j = 1; j < 4; ++j)
        for (const int k : {1, 2, 3, 5, 6, 7}) lower(j, k) = 0;
    const test::PrintDesign design({{10, 5, 9}, {10, 4, 4}}, lower, test::filled(5, 9, 0));
    WorkshopOptions options;
    options.mould.draft_deg = 5;  // 8.7 mm over 100; the wall between the pockets is 4 mm
    const auto pack = mould_pack(design.view(), options);
    ASSERT_TRUE(pack.has_value());
    EXPECT_EQ(pack->findings.front().code(), "narrow_foam");
    options.mould.draft_deg = 0.5;
    EXPECT_EQ(mould_pack(design.view(), options)->findings.front().code(), "draft");
}

TEST(MouldPack, WhatTheCaseLeavesNoRoomForIsToBeTrimmed) {
    test::PrintDesign design({{4, 3, 3}, {10, 10, 10}}, test::filled(3, 3, 2), test::filled(3, 3, 2));
    Grid<snug::Run> available = all_blocks(design.space.blocks);
    available(0, 0).first = 1;
    design.shorten(std::move(available));
    WorkshopOptions options;
    options.mould.draft_deg = 0;
    const auto pack = mould_pack(design.view(), options);
    ASSERT_EQ(pack->findings.size(), 1u);
    EXPECT_EQ(pack->findings[0].code(), "trim");
    EXPECT_NE(
        text(pack->findings[0].message).find("1 block at the outer side of the lower foam, 0.001 litres"),
        std::string::npos);
}

TEST(MouldPack, RefusesWhatCannotBeMadeWithWhatCan) {
    const test::PrintDesign design({{2, 2, 2}, {15, 15, 22}}, test::filled(2, 2, 1), test::filled(2, 2, 1));
    WorkshopOptions options;
    options.print.bed_mm = {24, 24, 24};
    auto pack = mould_pack(design.view(), options);
    ASSERT_FALSE(pack.has_value());
    EXPECT_EQ(pack.error().kind, ErrorKind::usage);
    EXPECT_EQ(
        text(pack.error().message),
        "a bed of 24 x 24 x 24 mm is smaller than a block of foam with the mould's walls, which takes 25 x "
        "18 x 23 mm on it; take a bed of at least that, smaller blocks or thinner walls");
    options.print.bed_mm = {25, 18, 23};
    EXPECT_EQ(text(mould_pack(design.view(), options)->figures.front().value), "4");
    options.mould.wall_mm = std::nan("");
    EXPECT_FALSE(mould_pack(design.view(), options).has_value());
    options.mould = {};
    options.print.bed_mm.z = 5;
    EXPECT_FALSE(mould_pack(design.view(), options).has_value());
    const test::PrintDesign many({{2, 100, 100}, {15, 15, 22}}, test::filled(100, 100, 1),
                                 test::filled(100, 100, 1));
    options.print.bed_mm = {30, 30, 30};
    pack = mould_pack(many.view(), options);
    ASSERT_FALSE(pack.has_value());
    EXPECT_NE(text(pack.error().message).find("more than 1,000 parts"), std::string::npos);
    const test::PrintDesign none({{2, 2, 2}, {15, 15, 22}}, test::filled(2, 2, 0), test::filled(2, 2, 0));
    EXPECT_FALSE(mould_pack(none.view(), {}).has_value());
}

}  // namespace
}  // namespace snug
