#include "snug/design/options_schema.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "snug/design/command_line.h"
#include "snug/design/project.h"

#include "tests/support/random_options.h"

// What the page's fields are made from.

namespace snug {
namespace {

using Json = nlohmann::json;

Json schema() {
    return Json::parse(options_schema());
}

Json dependent(const Design& design) {
    return Json::parse(dependent_options(design));
}

TEST(OptionsSchema, SaysWhatAProjectMayHave) {
    const Json all = schema();
    EXPECT_EQ(all["space.blocks"]["none"], "auto");
    EXPECT_EQ(all["space.blocks"]["count"], 3);
    EXPECT_EQ(all["parting.level"]["none"], "auto");
    EXPECT_EQ(all["object.longest_mm"].count("none"), 0u) << "null";
    EXPECT_EQ(all["object.units"].count("none"), 0u) << "a project says null where the flag says auto";
    EXPECT_EQ(all["workshop.mass_kg"]["optional"], true);
    EXPECT_EQ(all["workshop.for"]["optional"], true);
    EXPECT_EQ(all["case.base_mm"]["optional"], true);
    EXPECT_EQ(all["case.play_mm"].count("optional"), 0u);
    EXPECT_EQ(all["case.base_mm"]["count"], 2);
    EXPECT_EQ(all["object.clean.cut_plane"]["count"], 4);
    EXPECT_EQ(all["fit.notches"]["kind"], "group");
    EXPECT_EQ(all["fit.notches"]["label"], (Json{"Notches", "指かけ"}));
    EXPECT_EQ(all["fit.least_rib_mm"]["label"], (Json{"the least rib", "リブの最小厚さ"}));
    EXPECT_EQ(all["fit.notches.room_mm"]["default"], 25);
    EXPECT_EQ(all.count("workshop.mill"), 0u) << "always there";
    for (const char* several : {"space.wall_mm", "cut.clearance_mm"}) {
        EXPECT_EQ(all[several]["count"], 6);
        EXPECT_EQ(all[several]["or_one"], true);
    }
}

TEST(OptionsSchema, SlidersEndWithinTheRange) {
    const Json all = schema();
    for (const auto& [path, row] : all.items()) {
        if (!row.contains("often")) continue;
        EXPECT_LT(row["often"].get<double>(), row["most"].get<double>()) << path;
        EXPECT_GT(row["often"].get<double>(), row["least"].get<double>()) << path;
    }
}

TEST(OptionsSchema, TighterBoundsAreThoseOfTheLibrary) {
    test::Random random(11);
    for (int i = 0; i < 40; ++i) {
        Design design;
        design.space.block_mm = {random.between(1, 30), random.between(1, 30), random.between(1, 30)};
        design.space.blocks = Vec3i{random.integer(1, 50), 9, 9};
        const Json bounds = dependent(design);
        const double least = bounds["cut.clearance_mm"]["least"];
        design.cut.clearance_mm = Clearance(least);
        EXPECT_TRUE(checked(design).has_value()) << least;
        design.cut.clearance_mm = Clearance(least - 1e-6);
        EXPECT_FALSE(checked(design).has_value()) << least;
        design.cut.clearance_mm = Clearance(0);
        design.parting.level = bounds["parting.level"]["most"].get<int>();
        EXPECT_TRUE(checked(design).has_value());
        ++design.parting.level->each.front();
        EXPECT_FALSE(checked(design).has_value());
    }
}

TEST(OptionsSchema, WhatIsLeftOpenFollowsOtherChoices) {
    Design design;
    EXPECT_EQ(schema()["space.wall_mm"]["fitted"], 50);
    EXPECT_EQ(schema()["space.wall_mm"]["tray"], 25.4);
    design.space.block_mm = {12, 10, 10};
    design.workshop.mill.cutter_mm = 5;
    Json usual = dependent(design);
    EXPECT_EQ(usual["workshop.sheets.thickness_mm"]["usual"], 12);
    EXPECT_EQ(usual["workshop.mill.step_down_mm"]["usual"], 2.5);
    design.workshop.sheets.thickness_mm = 6;
    design.workshop.mill.step_down_mm = 1;
    usual = dependent(design);
    EXPECT_EQ(usual["workshop.sheets.thickness_mm"]["usual"], 6);
    EXPECT_EQ(usual["workshop.mill.step_down_mm"]["usual"], 1);
}

TEST(CommandLine, SaysAnotherLanguageThanEnglish) {
    EXPECT_EQ(command_line("a.stl", {}, built_in_names()), "snug make a.stl -o a-foam");
    EXPECT_EQ(command_line("a.stl", {}, built_in_names(), Language::japanese),
              "snug make a.stl --language=ja -o a-foam");
}

}  // namespace
}  // namespace snug
