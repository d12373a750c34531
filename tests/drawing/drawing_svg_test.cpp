#include "snug/drawing/drawing_svg.h"

#include <string>

#include <gtest/gtest.h>

namespace snug {
namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Drawing sheet(double step_mm) {
    Drawing drawing;
    drawing.size_mm = {100, 50};
    drawing.layers = {{"shapes", {}, step_mm}};
    return drawing;
}

PathItem square(Vec2d corner, Color fill) {
    return {{{corner, corner + Vec2d{1, 0}, corner + Vec2d{1, 1}, corner + Vec2d{0, 1}}}, true, fill, {}};
}

TEST(DrawingSvg, WholeStepsGiveShortPathsThatDoNotDrift) {
    Drawing drawing = sheet(0.1);
    // Corners that lie a third of a step apart: rounded one by one, not step after step.
    PathItem path;
    path.closed = false;
    path.pen = Pen{{1, 2, 3}, 0.2, {}};
    path.lines = {{}};
    for (int i = 0; i <= 300; ++i) path.lines[0].push_back({i / 30.0, 2});
    drawing.items.push_back({0, path});
    const std::string svg = drawing_svg(drawing);
    EXPECT_TRUE(holds(svg, "scale(0.1)"));
    EXPECT_TRUE(holds(svg, "stroke-width=\"2\"")) << "in steps";
    std::size_t at = svg.find("d=\"M0 20l") + 9;
    int x = 0;
    for (int i = 0; i < 300; ++i) {
        std::size_t used = 0;
        x += std::stoi(svg.substr(at), &used);
        at += used;
        EXPECT_EQ(std::stoi(svg.substr(at), &used), 0);
        at += used;
    }
    EXPECT_EQ(x, 100);
}

TEST(DrawingSvg, PathsOfOneLookAreOneGroupAndKeepTheirOrder) {
    Drawing drawing = sheet(0.1);
    for (int i = 0; i < 5; ++i) drawing.items.push_back({0, square({i * 2.0, 0}, {255, 0, 0})});
    PathItem clear = square({0, 5}, {0, 0, 255});
    clear.fill_opacity = 0.25;
    drawing.items.push_back({0, clear});
    const std::string svg = drawing_svg(drawing);
    std::size_t groups = 0;
    for (std::size_t at = svg.find("<g transform"); at != std::string::npos;
         at = svg.find("<g transform", at + 1))
        ++groups;
    EXPECT_EQ(groups, 2u);
    EXPECT_LT(svg.find("#ff0000"), svg.find("fill-opacity=\"0.25\""));
    EXPECT_LT(svg.find("fill-opacity=\"0.25\""), svg.find("#0000ff"));
}

TEST(DrawingSvg, WhatOnlyAScreenShowsIsWrittenWhereItIsAskedFor) {
    Drawing drawing = sheet(0);
    TextItem text;
    text.at = {10, 20};
    text.text = "foam & more";
    drawing.items.push_back({0, text});
    const std::string plain = drawing_svg(drawing);
    for (const char* part : {"opacity", "halo", "matrix", "spacing", "tspan", "stroke"})
        EXPECT_FALSE(holds(plain, part)) << part;
    text.lead = "LID <";
    text.opacity = 0.5;
    text.spacing_mm = 0.25;
    text.halo = Pen{{255, 255, 255}, 1, {}};
    text.plane = TextPlane{{0.5, 0.25}, {-0.5, 0.25}};
    drawing.items = {{0, text}};
    const std::string svg = drawing_svg(drawing);
    for (const char* part :
         {"<tspan font-weight=\"bold\">LID &lt;</tspan> foam &amp; more", "fill-opacity=\"0.5\"",
          "letter-spacing=\"0.25\"", "paint-order=\"stroke\"", "matrix(0.5 0.25 -0.5 0.25 10 20)"})
        EXPECT_TRUE(holds(svg, part)) << part << "\n" << svg;
}

}  // namespace
}  // namespace snug
