#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "snug/base/wide_text.h"
#include "snug/design/command_line.h"
#include "snug/design/option_json.h"
#include "snug/design/option_list.h"
#include "snug/design/options_page.h"
#include "snug/design/options_schema.h"
#include "snug/design/project.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/random_options.h"

// What follows from the table of options. SNUG_CASES sets how many random designs there are.

namespace snug {
namespace {

using test::Random;

int cases() {
    return test::cases(150);
}

std::string line_of(const Design& design) {
    return command_line("vase.stl", design, built_in_names());
}

TEST(Options, EachIsDescribedOnce) {
    Design design;
    std::set<std::string> paths;
    for (const Option& option : all_options(design).options) {
        EXPECT_TRUE(paths.insert(option.path).second) << option.path;
        EXPECT_FALSE(option.row.label.empty() || option.row.help.empty()) << option.path;
    }
    EXPECT_GT(paths.size(), 75u);
    std::set<std::string> flags;
    for (const Flag& flag : design_flags()) {
        EXPECT_TRUE(flags.insert(flag.name).second) << flag.name;
        EXPECT_EQ(flag.name.substr(0, 2), "--");
        EXPECT_GT(flag.help.size(), 10u) << flag.name;
    }
}

bool is_japanese(std::string_view text) {
    while (!text.empty()) {
        const auto [character, bytes] = first_character(text);
        if (is_wide(character)) return true;
        text.remove_prefix(bytes);
    }
    return false;
}

/// Words that an option may have besides, such as "auto", are typed so in both languages.
void expect_both(const Words& words, const std::string& of) {
    EXPECT_TRUE(is_japanese(words.japanese)) << of << ": " << words.english;
    EXPECT_FALSE(is_japanese(words.english)) << of;
}

TEST(Options, EachIsDescribedInJapanese) {
    Design design;
    const OptionList all = all_options(design);
    for (const Option& option : all.options) {
        expect_both(option.row.label, option.path);
        expect_both(option.row.help, option.path);
    }
    for (const OptionGroup& group : all.groups) expect_both(group.row.title, group.path);
    for (const BoundFlag& flag : all.flags) expect_both(flag.help, std::string(flag.flag));
    for (const Flag& flag : design_flags(Language::japanese))
        EXPECT_TRUE(is_japanese(flag.help)) << flag.name;
}

TEST(Options, WhatIsOutOfRangeIsSaidInBothLanguages) {
    Design design;
    design.fit.least_rib_mm = -3;
    const Message message = checked(design).error().message;
    EXPECT_EQ(text(message), "the least rib is -3 mm, but must be from 0 to 10000 mm");
    EXPECT_EQ(text(message, Language::japanese),
              "リブの最小厚さが -3 mm になっています。使える範囲は 0 から 10000 mm までです。");
}

TEST(Options, TheCommandLineOfADesignGivesTheDesign) {
    std::set<std::string> changed;
    for (int seed = 0; seed < cases(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        Design design = test::random_options(random);
        const auto typed = flags_for(design, built_in_names());
        const auto again = with_flags(typed, {}, false, built_in_names());
        ASSERT_TRUE(again) << "seed " << seed << ": " << text(again.error().message) << "\n"
                           << line_of(design);
        const auto possible = checked(*again);
        ASSERT_TRUE(possible) << "seed " << seed << ": " << text(possible.error().message) << "\n"
                              << line_of(design);
        ASSERT_EQ(design_json(*possible), design_json(design)) << "seed " << seed << "\n" << line_of(design);
        ASSERT_TRUE(*possible == design) << "seed " << seed;

        Design usual;
        const OptionList usually = options_of(usual);
        for (const Option& option : options_of(design).options) {
            const Option* const before = usually.find(option.path);
            if (!before || json_of(*before) != json_of(option)) changed.insert(option.path);
        }
    }
    if (cases() < 150) return;
    Design full;
    for (const Option& option : all_options(full).options)
        // One item is of the only object and lies in the only layer.
        if (option.path != "items.0.object" && option.path != "items.0.layer") {
            EXPECT_TRUE(changed.contains(option.path)) << option.path << " was never changed";
        }
}

TEST(Options, TheHelpNamesEveryWordOfAChoice) {
    std::map<std::string, std::string> takes;
    for (const Flag& flag : design_flags()) takes[flag.name] = flag.takes;
    EXPECT_EQ(takes["--origin"], "corner|centre");
    EXPECT_EQ(takes["--units"], "mm|cm|m|in|auto");
    EXPECT_EQ(takes["--for"].substr(0, 20), "sponge|sheets|print|");
    EXPECT_EQ(takes["--least-rib"], "MM");
    EXPECT_EQ(takes["--cap"], "");
}

TEST(Options, TheProjectOfADesignGivesTheDesign) {
    for (int seed = 0; seed < cases(); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Project project = test::project_of("vase.stl", test::random_options(random));
        const auto again = parse_project(project_json(project));
        ASSERT_TRUE(again) << "seed " << seed << ": " << text(again.error().message);
        ASSERT_TRUE(*again == project) << "seed " << seed;
        ASSERT_EQ(project_json(*again), project_json(project)) << "seed " << seed;
    }
}

TEST(Options, TheCommandLineSaysWhatDiffersAndNothingElse) {
    const auto said = [](auto change) {
        Design design;
        change(design);
        return line_of(checked(design).value());
    };
    EXPECT_EQ(said([](Design&) {}), "snug make vase.stl -o vase-foam");
    EXPECT_EQ(said([](Design& d) { d.space.blocks.reset(); }),
              "snug make vase.stl --blocks=auto -o vase-foam");
    EXPECT_EQ(said([](Design& d) {
                  d.cut.clearance_mm = {{1, 2, 2}, {1, 2, 2}};
              }),
              "snug make vase.stl --clearance=1,2,2 -o vase-foam");
    EXPECT_EQ(
        said([](Design& d) { apply(find_preset(built_in_presets(), "slit-10").value(), d); }).substr(0, 37),
        "snug make vase.stl --preset=slit-10 -");
    EXPECT_EQ(said([](Design& d) {
                  d.fit.notches = NotchOptions{};
                  d.fit.notches->axis = NotchAxis::z;
                  d.object.cap = true;
              }),
              "snug make vase.stl --cap --notches=80x40x25 --notch-axis=z -o vase-foam");
    EXPECT_EQ(said([](Design& d) {
                  d.case_options.inside_mm = Vec3d{155, 284, 425};
                  d.case_options.lid_mm = 45;
              }),
              "snug make vase.stl --case=425x284x155:45 -o vase-foam");
    EXPECT_EQ(said([](Design& d) {
                  apply(find_preset(built_in_presets(), "mill").value(), d);
                  d.workshop.density_kg_m3 = 33;
                  d.space.blocks.reset();
                  d.workshop.work = Workshop::mill;
                  d.workshop.mill.cutter_mm = 8;
                  d.workshop.price_per_litre = 0.8;
                  d.workshop.currency = "a'b";
              }),
              "snug make vase.stl --for=mill --price='0.8a'\\''b' --cutter=8 -o vase-foam");
    EXPECT_EQ(said([](Design& d) { d.workshop.sheets.dxf = false; }),
              "snug make vase.stl --set=workshop.sheets.dxf=false -o vase-foam");
    EXPECT_EQ(command_line("-my vase.v2.stl", {}, built_in_names()),
              "snug make './-my vase.v2.stl' -o './-my vase.v2-foam'");
}

TEST(Options, WhatIsTypedWronglyIsNamedWithWhatItTakes) {
    const auto refusal = [](std::initializer_list<TypedFlag> typed) {
        const auto design = with_flags({typed.begin(), typed.size()}, {}, false, built_in_names());
        return design ? std::string() : text(design.error().message);
    };
    EXPECT_EQ(refusal({{"--units", "miles"}}), "--units takes mm, cm, m, in or auto, not \"miles\"");
    EXPECT_EQ(refusal({{"--scale", "big"}}), "--scale takes a number, not \"big\"");
    EXPECT_EQ(refusal({{"--liner", "1,5"}}), "--liner takes a number of mm, not \"1,5\"");
    EXPECT_EQ(refusal({{"--blocks", "1.5x2x2"}}),
              "--blocks takes three numbers such as 30x18x18, or auto, not \"1.5x2x2\"");
    EXPECT_EQ(refusal({{"--notch-axis", "y"}}), "--notch-axis belongs to --notches");
    EXPECT_EQ(refusal({{"--set", "fit.least=3"}}),
              "--set fit.least is not an option that this version of Snug knows");
    EXPECT_EQ(refusal({{"--set", "fit"}}).substr(0, 5), "--set");
    EXPECT_EQ(refusal({{"--set", "fit.least_rib_mm=thin"}}), "--set fit.least_rib_mm must be a number");
}

TEST(Options, AProjectOutOfRangeNamesTheFieldWithItsPath) {
    const std::string good = project_json(test::project_of("vase.stl"));
    const auto refusal = [&](const char* path, const nlohmann::json& value) {
        auto json = nlohmann::json::parse(good);
        json["design"][nlohmann::json::json_pointer(path)] = value;
        const auto project = parse_project(json.dump());
        return project ? std::string() : text(project.error().message);
    };
    EXPECT_EQ(refusal("/fit/least_rib_mm", 20000),
              "design.fit.least_rib_mm: the least rib is 20000 mm, but must be from 0 to 10000 mm");
    EXPECT_EQ(refusal("/workshop/mill/pin_mm", 0.5).substr(0, 27), "design.workshop.mill.pin_mm");
    EXPECT_EQ(refusal("/workshop/sheets/margin_mm", 400).substr(0, 32), "design.workshop.sheets.margin_mm");
    EXPECT_EQ(refusal("/workshop/bricks/lid_color", "mauve").substr(0, 32),
              "design.workshop.bricks.lid_color");
    EXPECT_EQ(refusal("/case/lid_mm", -1).substr(0, 18), "design.case.lid_mm");
    EXPECT_EQ(refusal("/cut/clearance_mm", -7).substr(0, 23), "design.cut.clearance_mm");
    EXPECT_EQ(refusal("/fit/notches", {{"wide", 1}}),
              "design.fit.notches.wide is not an option that this version of Snug knows");
    EXPECT_EQ(refusal("/search/weights", {{"speed", 1}}).substr(0, 21), "design.search.weights");
    EXPECT_EQ(refusal("/fit", 3), "design.fit must be a JSON object");
}

TEST(OptionsPage, SaysNumbersAsPeopleReadThem) {
    const std::string page = options_page();
    const auto values = [&](const std::string& path) {
        const std::size_t row = page.find("| `" + path + "` |");
        const std::size_t flag = page.find('|', row + 1), begin = page.find('|', flag + 1) + 2;
        return row == std::string::npos ? "" : page.substr(begin, page.find(" |", begin) - begin);
    };
    EXPECT_NE(page.find("| `0`: from the spacing |"), std::string::npos);
    EXPECT_EQ(values("object.scale"), "0.000000001 to 1,000,000,000");
    EXPECT_EQ(values("object.point_radius_mm"), "0, or 0.000001 to 1,000,000 mm");
    EXPECT_EQ(values("placement.offset_mm"), "-1,000,000 to 1,000,000 mm");
    EXPECT_EQ(values("search.weights"), "0 to 1,000");
    EXPECT_EQ(values("search.seed"), "0 or more");
    EXPECT_EQ(values("object.clean.cut_plane"), "4 numbers");
    EXPECT_EQ(values("workshop.bricks.family"), "`2x4,1x2,...`");
}

TEST(OptionsPage, IsWhatTheTableSays) {
    const std::string path = SNUG_SOURCE_DIR "/docs/options.md";
    if (std::getenv("SNUG_WRITE")) std::ofstream(path) << options_page();
    std::ifstream file(path);
    const std::string committed{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_TRUE(committed == options_page())
        << "write it again: SNUG_WRITE=1 build/tests/snug_tests --gtest_filter=OptionsPage.*";
}

TEST(OptionsSchema, HasEveryOptionWithItsDefault) {
    const auto schema = nlohmann::json::parse(options_schema());
    EXPECT_EQ(schema["workshop.mill.cutter_mm"]["least"], 0.5);
    EXPECT_EQ(schema["workshop.mill.cutter_mm"]["default"], 6);
    EXPECT_EQ(schema["object.units"]["words"], (nlohmann::json{"mm", "cm", "m", "in"}));
    EXPECT_EQ(schema["space.blocks"]["default"], (nlohmann::json{30, 18, 18}));
    Design design;
    const OptionList all = all_options(design);
    const auto listed = std::count_if(all.groups.begin(), all.groups.end(),
                                      [](const OptionGroup& group) { return group.optional || group.list; });
    EXPECT_EQ(schema.size(), all.options.size() + static_cast<std::size_t>(listed));
}

}  // namespace
}  // namespace snug
