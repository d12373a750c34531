#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "snug/base/text.h"
#include "snug/design/presets.h"
#include "snug/design/project.h"
#include "snug/words/words.h"

#include "tests/support/random.h"
#include "tests/support/random_options.h"

namespace snug {
namespace {

using test::Random;

Design random_design_options(Random& random) {
    Design design;
    if (random.chance(0.5)) design.object.units = static_cast<Unit>(random.integer(0, 3));
    design.object.scale = random.between(0.001, 1000);
    if (random.chance(0.5)) design.object.longest_mm = random.between(1, 1000);
    design.object.cap = random.chance(0.5);
    design.space.preset = random.chance(0.5) ? "slit-10" : "Schaum \"ü\"";
    design.space.blocks.reset();
    if (random.chance(0.7))
        design.space.blocks =
            Vec3i{random.integer(1, 4096), random.integer(1, 4096), random.integer(1, 4096)};
    design.space.block_mm = {random.between(0.1, 10000), random.between(0.1, 10), random.between(0.1, 100)};
    if (random.chance(0.5)) design.space.wall_mm = equal_walls(random.between(0, 100));
    if (random.chance(0.5)) {
        design.case_options.name = "a case";
        design.case_options.inside_mm = Vec3d{random.between(50, 100), 200, random.between(200, 300)};
        design.case_options.lid_mm = random.between(0, 40);
        design.case_options.base_mm = CrossSection{random.between(100, 200), 190};
        design.case_options.corner_radius_mm = random.between(0, 40);
        design.case_options.division = Division::across;
        design.case_options.divisor.reset();
    }
    if (random.chance(0.3)) design.space.wall_mm = Walls{1, 2, 3.5, random.between(0, 100), 5, 6};
    design.placement.rotation_deg = {random.between(-360, 360), 90, random.between(-1, 1) * 1e-9};
    design.placement.offset_mm = {random.between(-10, 10), 0, -0.5};
    design.cut.clearance_mm = random.between(-0.04, 20);
    if (random.chance(0.5)) design.cut.clearance_mm = {{0, random.between(0, 2), 3}, {1, 2, 0}};
    design.cut.liner_mm = random.between(0, 3);
    design.cut.cut_on_touch = random.chance(0.5);
    design.fit.least_rib_mm = random.between(0, 40);
    if (random.chance(0.5)) design.fit.creep_kpa = random.between(1, 40);
    if (random.chance(0.5)) {
        design.fit.notches = NotchOptions{random.between(1, 100), 40, 25, {}, {}, {}};
        if (random.chance(0.5)) design.fit.notches->axis = static_cast<NotchAxis>(random.integer(0, 1));
        if (random.chance(0.5)) design.fit.notches->first_mm = random.between(-100, 100);
        if (random.chance(0.5)) design.fit.notches->second_mm = random.between(-100, 100);
    }
    if (random.chance(0.5) && design.space.blocks)
        design.parting.level = random.integer(0, design.space.blocks->x);
    if (random.chance(0.5)) design.output.formats = {"ply"};
    return design;
}

std::string problem_of(std::string_view json) {
    const auto project = parse_project(json);
    return project ? "" : snug::text(project.error().message);
}

/// Of one to four objects, of which some lie there more than once.
Project random_project(Random& random) {
    Project project{{}, random_design_options(random)};
    project.design.items.clear();
    const int objects = random.integer(1, 4);
    for (int i = 0; i < objects; ++i) {
        const std::string name = "vase" + std::to_string(i) + ".stl";
        project.objects.push_back({{name, random.bits() >> 20, std::string(64, 'a')}, {}});
        if (random.chance(0.3)) project.objects.back().own = random_design_options(random).object;
        for (int count = random.integer(1, 3); count > 0; --count) {
            ItemOptions item;
            item.object = i;
            if (random.chance(0.3)) item.name = "a \"vase\", \u82b1\u74f6";
            if (random.chance(0.3)) item.group = "pair";
            if (random.chance(0.3)) item.rotation_deg = Vec3d{random.between(-180, 180), 0, 90};
            if (random.chance(0.5)) item.offset_mm = Vec3d{0, random.between(-50, 50), 3};
            if (random.chance(0.3)) item.clearance_mm = Clearance{{1, 2, 3}, {random.between(0, 3), 0, 0}};
            if (random.chance(0.3)) item.mass_kg = random.between(0.1, 9);
            project.design.items.push_back(item);
        }
    }
    return project;
}

TEST(Project, ReadsBackAsItWasWritten) {
    const bool held = rc::check("project -> JSON -> project", [](std::uint64_t seed) {
        Random random(seed);
        const Project project = random_project(random);
        const std::string text = project_json(project);
        const auto read = parse_project(text);
        RC_ASSERT(read.has_value());
        RC_ASSERT(*read == project);
        RC_ASSERT(project_json(*read) == text);
    });
    EXPECT_TRUE(held);
}

TEST(Project, SaysWhatIsWrong) {
    const std::string good = project_json(test::project_of("vase.stl"));
    const auto with = [&](std::string_view from, std::string_view to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return problem_of(text);
    };
    EXPECT_EQ(problem_of(good), "");
    EXPECT_NE(with("\"snug\": 2", "\"snug\": 3").find("newer"), std::string::npos);
    EXPECT_EQ(with("\"snug\": 2", "\"snug\": \"x\""), "snug must be a whole number");
    EXPECT_EQ(with("\"scale\": 1.0", "\"scale\": \"big\""), "design.object.scale must be a number");
    EXPECT_EQ(with("\"scale\"", "\"skale\""),
              "design.object.skale is not an option that this version of Snug knows");
    EXPECT_EQ(with("\"vase.stl\"", "\"../vase.stl\""), "objects.0.name must be a file name without folders");
    EXPECT_EQ(with("\"auto\"", "\"low\""),
              "design.parting.level must be a whole number, or a list of them for several layers, or auto");
    EXPECT_EQ(with("30,\n", "0,\n"),
              "design.space.blocks: a count of blocks is 0, but must be from 1 to 4096");
    EXPECT_NE(problem_of(good.substr(0, good.size() / 2)).find("not valid JSON"), std::string::npos);
    EXPECT_NE(problem_of("[]").find("must be a JSON object"), std::string::npos);
    EXPECT_NE(problem_of("{}").find("snug is missing"), std::string::npos);
    EXPECT_NE(problem_of("").find("not valid JSON"), std::string::npos);
}

TEST(Project, OfVersion1HasOneObjectAndOneItem) {
    const auto read = parse_project(
        R"({"snug": 1, "object": {"name": "vase.stl", "bytes": 7}, "design": {"placement": {"offset_mm": [1, 2, 3]}}})");
    ASSERT_TRUE(read) << snug::text(read.error().message);
    ASSERT_EQ(read->objects.size(), 1u);
    EXPECT_EQ(read->objects.front().file, (ObjectFile{"vase.stl", 7, ""}));
    EXPECT_EQ(read->design.items, std::vector<ItemOptions>{1});
    EXPECT_EQ(read->design.placement.offset_mm, (Vec3d{1, 2, 3}));
    EXPECT_EQ(problem_of(R"({"snug": 1, "objects": [{"name": "a.stl"}], "design": {}})"),
              "object is missing");
    EXPECT_EQ(problem_of(R"({"snug": 2, "object": {"name": "a.stl"}, "design": {}})"), "objects is missing");
}

TEST(Project, SaysWhatIsWrongWithItsItems) {
    const auto with = [](const char* objects, const char* items) {
        return problem_of(std::string(R"({"snug": 2, "objects": )") + objects + R"(, "design": {"items": )" +
                          items + "}}");
    };
    const char* const two = R"([{"name": "a.stl"}, {"name": "b.stl"}])";
    EXPECT_EQ(with(two, R"([{"object": 0}, {"object": 1}, {"object": 1, "mass_kg": 2}])"), "");
    EXPECT_EQ(with(two, "[{}]"), "objects.1 must be the object of an item");
    EXPECT_EQ(with(two, R"([{}, {"object": 2}])"),
              "design.items.1.object must be the number of an object, from 0 to 1");
    EXPECT_EQ(with(two, R"([{}, {"object": 1, "turn": 2}])"),
              "design.items.1.turn is not an option that this version of Snug knows");
    EXPECT_EQ(with(two, R"([{}, {"object": 1, "mass_kg": 0}])").substr(0, 23), "design.items.1.mass_kg:");
    EXPECT_EQ(with(two, R"([{}, {"object": 1, "clearance_mm": -7}])").substr(0, 28),
              "design.items.1.clearance_mm:");
    EXPECT_EQ(with(two, "[]"), "design.items must be a list of 1 to 1000 items");
    EXPECT_EQ(with(two, "3"), "design.items must be a list of 1 to 1000 items");
    EXPECT_EQ(with("[]", "[{}]"), "objects must be a list of 1 to 1000 items");
    EXPECT_EQ(with(R"([{"name": "a.stl", "options": {"scale": -1}}])", "[{}]").substr(0, 26),
              "objects.0.options.scale: t");
    EXPECT_EQ(with(R"([{"name": "a.stl", "options": {"skale": 1}}])", "[{}]"),
              "objects.0.options.skale is not an option that this version of Snug knows");
}

TEST(Project, AnyDamageIsASentenceAndNeverACrash) {
    const std::string good = project_json(test::project_of("vase.stl"));
    for (int seed = 0; seed < 3000; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::string text = good;
        for (int i = random.integer(1, 4); i > 0; --i) {
            const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
            if (random.chance(0.5))
                text[at] = static_cast<char>(random.integer(0, 255));
            else
                text.erase(at, static_cast<std::size_t>(random.integer(1, 9)));
        }
        const auto project = parse_project(text);
        ASSERT_TRUE(project || !snug::text(project.error().message).empty()) << seed;
    }
}

TEST(Design, RefusesWhatNoOneCanCut) {
    const auto refused = [](auto change) {
        Design design;
        change(design);
        const auto result = checked(design);
        return result ? std::string() : snug::text(result.error().message);
    };
    EXPECT_EQ(refused([](Design&) {}), "");
    EXPECT_NE(refused([](Design& d) { d.space.blocks = Vec3i{0, 1, 1}; }), "");
    EXPECT_NE(refused([](Design& d) { d.space.blocks = Vec3i{1, 4097, 1}; }), "");
    EXPECT_NE(refused([](Design& d) { d.space.block_mm.y = -1; }), "");
    EXPECT_NE(refused([](Design& d) { d.space.block_mm.z = 10001; }), "");
    EXPECT_NE(refused([](Design& d) { d.cut.clearance_mm = -6.1; }), "");
    EXPECT_EQ(refused([](Design& d) { d.cut.clearance_mm = -6; }), "");
    EXPECT_NE(refused([](Design& d) { d.parting.level = 31; }), "");
    EXPECT_NE(refused([](Design& d) { d.object.scale = 0; }), "");
    EXPECT_NE(refused([](Design& d) { d.object.scale = std::numeric_limits<double>::quiet_NaN(); }), "");
    EXPECT_NE(refused([](Design& d) { d.output.formats = {"dwg"}; }), "");
}

TEST(Presets, AllBuiltInOnesArePossibleAndTheDefaultIsThePapers) {
    Design untouched, preset;
    apply(built_in_presets().front(), preset);
    EXPECT_EQ(untouched, preset);
    for (const Preset& each : built_in_presets()) {
        Design design;
        apply(each, design);
        EXPECT_TRUE(checked(design).has_value()) << each.name;
    }
}

TEST(Presets, OwnOnesAreReadAndWrongOnesNamed) {
    const auto own = parse_presets(R"([{"name": "ours", "block_mm": [20, 12, 12], "clearance_mm": 1}])");
    ASSERT_TRUE(own.has_value());
    EXPECT_EQ(own->front().block_mm, (Vec3d{20, 12, 12}));
    const auto wrong = parse_presets(R"([{"name": "a", "block_mm": [1, 2, 3]}, {"name": "b"}])");
    ASSERT_FALSE(wrong.has_value());
    EXPECT_EQ(snug::text(wrong.error().message), "preset 2.block_mm is missing");
    const auto thin = parse_presets(R"([{"name": "a", "block_mm": [1, 2, 3], "wall_mm": 0}])");
    ASSERT_FALSE(thin.has_value());
    EXPECT_EQ(snug::text(thin.error().message), "preset 1.wall_mm must be above 0");
    EXPECT_NE(snug::text(find_preset(*own, "theirs").error().message).find("known are: ours"),
              std::string::npos);
}

TEST(Text, NumbersAreShortAndPlain) {
    EXPECT_EQ(number(0), "0");
    EXPECT_EQ(number(-0.0001), "0");
    EXPECT_EQ(number(15), "15");
    EXPECT_EQ(number(12.7), "12.7");
    EXPECT_EQ(number(-1.005, 1), "-1");
    EXPECT_EQ(number(0.05, 1), "0.1");
    EXPECT_EQ(number(1e12, 3), "1000000000000");
    EXPECT_EQ(grouped(1383712), "1,383,712");
    EXPECT_EQ(grouped(12), "12");
    EXPECT_EQ(counted(1, "block", "blocks"), "1 block");
}

}  // namespace
}  // namespace snug
