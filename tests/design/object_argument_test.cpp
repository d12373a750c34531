#include "snug/design/object_argument.h"

#include <gtest/gtest.h>

#include "snug/base/rotation.h"

// Objects as they are typed.

namespace snug {
namespace {

using Choices = std::vector<std::pair<std::string, std::string>>;

TEST(ObjectArgument, TakesTheChoicesOffBehindTheLastColon) {
    const auto split = [](const char* text) { return object_argument(text); };
    EXPECT_EQ(split("a.stl").file, "a.stl");
    EXPECT_EQ(split("a.stl:count=2,move=0x40x0").file, "a.stl");
    EXPECT_EQ(split("a.stl:count=2,move=0x40x0").choices, (Choices{{"count", "2"}, {"move", "0x40x0"}}));
    EXPECT_EQ(split("a:b.stl:cap").file, "a:b.stl");
    EXPECT_EQ(split("a.stl:cut-plane=1x0x0x-5").choices, (Choices{{"cut-plane", "1x0x0x-5"}}));
    EXPECT_EQ(split("a.stl:name=a,b, c,cap").choices, (Choices{{"name", "a,b, c"}, {"cap", ""}}));
    EXPECT_EQ(split("a.stl:rotate=0,90,0,mass=1").choices, (Choices{{"rotate", "0,90,0"}, {"mass", "1"}}));
    EXPECT_EQ(split("a.stl:COUNT=2").choices, (Choices{{"COUNT", "2"}})) << "so that it can be said";
    for (const char* whole :
         {"C:/a.stl", "C:\\a.stl", "a:b", "a.stl:", ":count=2", "", ":", "a.stl:count", "http://a/b=c"})
        EXPECT_EQ(split(whole).file, whole);
}

TEST(ObjectArgument, OneFileWithEqualChoicesIsOneObject) {
    const std::vector<ObjectArgument> typed{{"a.stl", {{"mass", "1"}}},
                                            {"b.stl", {{"units", "cm"}}},
                                            {"a.stl", {{"count", "2"}, {"upright", "-y"}}},
                                            {"b.stl", {}},
                                            {"b.stl", {{"units", "cm"}, {"name", "lid, \"top\""}}}};
    std::vector<std::string> files;
    Design all;
    all.object.cap = true;
    const Project project = with_objects(typed, all, files).value();
    EXPECT_EQ(files, (std::vector<std::string>{"a.stl", "b.stl", "b.stl"}));
    ASSERT_EQ(project.objects.size(), 3u);
    EXPECT_FALSE(project.objects[0].own);
    ASSERT_TRUE(project.objects[1].own);
    EXPECT_EQ(project.objects[1].own->units, Unit::cm);
    EXPECT_TRUE(project.objects[1].own->cap) << "what holds for all holds for it, too";
    std::vector<int> objects;
    for (const ItemOptions& item : project.design.items) objects.push_back(item.object);
    EXPECT_EQ(objects, (std::vector<int>{0, 1, 0, 0, 2, 1}));
    EXPECT_EQ(project.design.items[0].mass_kg, 1);
    EXPECT_EQ(project.design.items[2].rotation_deg, (Vec3d{0, 0, 90}));
    EXPECT_EQ(project.design.items[5].name, "lid, \"top\"");
}

TEST(ObjectArgument, WhatIsToldOfItemsReadsBackAsTheSameItems) {
    Design all;
    all.object.cap = true;
    const std::vector<ObjectArgument> typed{
        {"a.stl", {{"mass", "1"}, {"move", "0x40.5x-3"}, {"group", "pair"}}},
        {"b.stl", {{"units", "cm"}, {"cut-plane", "0x0x1x-2.5"}, {"clearance", "1x2x3x4x5x6"}}},
        {"a.stl", {{"count", "3"}, {"rotate", "10x-20x30.25"}}},
        {"b.stl", {{"units", "cm"}, {"name", "lid, \"top\""}}}};
    std::vector<std::string> files;
    const Project project = with_objects(typed, all, files).value();
    const std::vector<std::string> told = typed_items(project, files);
    ASSERT_EQ(told.size(), 4u);
    EXPECT_EQ(told[0], "a.stl:group=pair,move=0x40.5x-3,mass=1");
    EXPECT_EQ(told[2], "a.stl:count=3,rotate=10x-20x30.25");
    std::vector<ObjectArgument> again;
    for (const std::string& text : told) again.push_back(object_argument(text));
    std::vector<std::string> same_files;
    EXPECT_EQ(with_objects(again, all, same_files).value(), project);
    EXPECT_EQ(same_files, files);
}

TEST(ObjectArgument, WhatPointsUpPointsUp) {
    const Vec3d axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const char* const names[] = {"x", "-x", "y", "-y", "z", "-z"};
    for (std::size_t i = 0; i < 6; ++i) {
        std::vector<std::string> files;
        const std::vector<ObjectArgument> typed{{"a.stl", {{"upright", names[i]}}}};
        const Project project = with_objects(typed, {}, files).value();
        EXPECT_EQ(project.design.search.upright, static_cast<Upright>(i / 2 + (i % 2) * 3)) << names[i];
        const Rotation rotation = rotation_from_euler(*project.design.items.front().rotation_deg);
        EXPECT_EQ(rotation(axes[i]), (Vec3d{1, 0, 0})) << names[i];
    }
}

}  // namespace
}  // namespace snug
