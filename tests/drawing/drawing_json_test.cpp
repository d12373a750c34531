#include "snug/drawing/drawing_json.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/random.h"

namespace snug {
namespace {

using Json = nlohmann::json;

constexpr double kHalfStep = 0.5e-4 + 1e-9;  // mm: four decimals

Json pages_of(const DrawingDocument& document) {
    return Json::parse(drawing_json(document));
}

Json item_of(DrawingItem item) {
    DrawingDocument document;
    document.pages.push_back({"page", {210, 297}, {{"notes", {}}}, {std::move(item)}});
    return pages_of(document).at(0).at("items").at(0);
}

TEST(DrawingJson, PagesKeepTheirOrderTitleAndSize) {
    DrawingDocument document;
    document.pages = {{"first", {210, 297}, {}, {}}, {"second", {215.9, 279.4}, {}, {}}};
    const Json pages = pages_of(document);
    ASSERT_EQ(pages.size(), 2U);
    EXPECT_EQ(pages[0].at("title"), "first");
    EXPECT_EQ(pages[1].at("title"), "second");
    EXPECT_EQ(pages[1].at("size"), Json::array({215.9, 279.4}));
    EXPECT_TRUE(pages[0].at("items").empty());
}

TEST(DrawingJson, ItemsStayInTheOrderInWhichTheyCoverEachOther) {
    Drawing page{"page", {100, 100}, {{"a", {}}, {"b", {}}}, {}};
    for (int i = 0; i < 5; ++i) {
        CircleItem circle;
        circle.radius_mm = i + 1;
        page.items.push_back({i % 2, circle});
    }
    DrawingDocument document;
    document.pages.push_back(page);
    const Json items = pages_of(document)[0].at("items");
    ASSERT_EQ(items.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(items[i].at("circle")[2], static_cast<double>(i + 1));
}

TEST(DrawingJson, WhatIsNotThereIsNull) {
    PathItem path;
    path.lines = {{{1, 2}, {3, 4}, {5, 6.5}}};
    path.closed = false;
    const Json item = item_of({0, path});
    EXPECT_EQ(item.at("path"), Json::array({Json::array({1, 2, 3, 4, 5, 6.5})}));
    EXPECT_EQ(item.at("closed"), false);
    EXPECT_TRUE(item.at("fill").is_null());
    EXPECT_TRUE(item.at("pen").is_null());
}

TEST(DrawingJson, ColoursAndPensAreSaidInFull) {
    CircleItem circle;
    circle.fill = Color{0, 10, 255};
    circle.pen = Pen{{255, 160, 1}, 0.35, {2, 1.5}};
    const Json item = item_of({0, circle});
    EXPECT_EQ(item.at("fill"), "#000aff");
    EXPECT_EQ(item.at("pen").at("color"), "#ffa001");
    EXPECT_EQ(item.at("pen").at("width"), 0.35);
    EXPECT_EQ(item.at("pen").at("dashes"), Json::array({2, 1.5}));
}

TEST(DrawingJson, TextIsWhatItWasWithAnchorAndTurn) {
    const TextAnchor anchors[] = {TextAnchor::start, TextAnchor::middle, TextAnchor::end};
    const char* const names[] = {"start", "middle", "end"};
    for (int i = 0; i < 3; ++i) {
        TextItem text;
        text.at = {12.5, 30};
        text.text = "1,204 \"blocks\" \\ \xc3\xa9 \xe4\xb8\x8b";
        text.anchor = anchors[i];
        text.turn_deg = 90 * i;
        text.bold = i == 1;
        const Json item = item_of({0, text});
        EXPECT_EQ(item.at("text"), text.text);
        EXPECT_EQ(item.at("anchor"), names[i]);
        EXPECT_EQ(item.at("turn"), 90 * i);
        EXPECT_EQ(item.at("bold"), i == 1);
        EXPECT_EQ(item.at("at"), Json::array({12.5, 30}));
    }
}

TEST(DrawingJson, ANameThatIsNoUtf8IsStillReadable) {
    TextItem text;
    text.text = "vase \xff\xfe.stl";
    const std::string read = item_of({0, text}).at("text");
    EXPECT_EQ(read.rfind("vase ", 0), 0U) << read;
    EXPECT_NE(read.find(".stl"), std::string::npos) << read;
}

TEST(DrawingJson, RandomPathsMoveByLessThanACutterCanFollow) {
    for (int seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(static_cast<std::uint64_t>(seed));
        PathItem path;
        path.lines.resize(static_cast<std::size_t>(1 + seed % 4));
        for (auto& line : path.lines)
            for (int i = 0; i < 20; ++i)
                line.push_back({random.between(-1000, 1000), random.between(-1000, 1000)});
        const Json lines = item_of({0, path}).at("path");
        ASSERT_EQ(lines.size(), path.lines.size());
        for (std::size_t l = 0; l < lines.size(); ++l) {
            ASSERT_EQ(lines[l].size(), 2 * path.lines[l].size());
            for (std::size_t i = 0; i < path.lines[l].size(); ++i) {
                EXPECT_NEAR(lines[l][2 * i].get<double>(), path.lines[l][i].x, kHalfStep);
                EXPECT_NEAR(lines[l][2 * i + 1].get<double>(), path.lines[l][i].y, kHalfStep);
            }
        }
    }
}

}  // namespace
}  // namespace snug
