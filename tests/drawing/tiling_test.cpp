#include "snug/drawing/tiling.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "snug/drawing/clip.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/drawing/page_builder.h"
#include "snug/words/words.h"

#include "tests/support/drawing_cells.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::items_on;
using test::Random;

double area_of(const std::vector<Vec2d>& loop) {
    double doubled = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()];
        doubled += a.x * b.y - a.y * b.x;
    }
    return doubled / 2;
}

std::vector<Vec2d> random_loop(Random& random, double extent) {
    std::vector<Vec2d> loop(static_cast<std::size_t>(random.integer(3, 8)));
    for (Vec2d& point : loop) point = {random.between(0, extent), random.between(0, extent)};
    return loop;
}

TEST(ClipTest, PiecesOfAWindowGridAddUpToTheWhole) {
    for (int seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const std::vector<Vec2d> loop = random_loop(random, 100);
        double area = 0, line_length = 0, whole_length = 0;
        for (std::size_t i = 0; i + 1 < loop.size(); ++i) whole_length += length(loop[i + 1] - loop[i]);
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 3; ++column) {
                const Window window{{column * 34.0, row * 26.0}, {(column + 1) * 34.0, (row + 1) * 26.0}};
                const auto part = clipped_loop(loop, window);
                area += area_of(part);
                for (const Vec2d p : part) {
                    EXPECT_TRUE(p.x >= window.min.x - 1e-9 && p.x <= window.max.x + 1e-9);
                    EXPECT_TRUE(p.y >= window.min.y - 1e-9 && p.y <= window.max.y + 1e-9);
                }
                for (const auto& piece : clipped_line(loop, window))
                    for (std::size_t i = 0; i + 1 < piece.size(); ++i)
                        line_length += length(piece[i + 1] - piece[i]);
            }
        EXPECT_NEAR(area, area_of(loop), 1e-4);
        EXPECT_NEAR(line_length, whole_length, 1e-4);
    }
}

/// A drawing with a shape, lines between blocks and words, of this size.
Drawing picture(Vec2d size, Random& random) {
    PageBuilder page("picture", size);
    page.layer("shape", {200, 0, 0});
    for (int i = 0; i < 5; ++i) page.loops({random_loop(random, std::min(size.x, size.y))}, Color{1, 2, 3});
    page.layer("words", {});
    for (int i = 0; i < 30; ++i)
        page.text({random.between(0, size.x), random.between(0, size.y)}, "w" + std::to_string(i));
    page.rectangle({}, size, {}, Pen{});
    return page.finish();
}

TEST(TilingTest, TilesHoldEverythingOnceAtTrueSize) {
    for (int seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Drawing whole = picture({random.between(20, 900), random.between(20, 900)}, random);
        const Vec2d paper = random.chance(0.5) ? Vec2d{210, 297} : Vec2d{215.9, 279.4};
        const auto pages = tiled(whole, paper);
        ASSERT_TRUE(pages);
        double area = 0, expected = 0;
        std::multiset<std::string> words;
        for (const Drawing& page : *pages) {
            EXPECT_NEAR(std::min(page.size_mm.x, page.size_mm.y), std::min(paper.x, paper.y), 1e-9);
            for (const PathItem& path : items_on<PathItem>(page, "shape"))
                for (const auto& loop : path.lines) area += area_of(loop);
            for (const TextItem& text : items_on<TextItem>(page, "words")) words.insert(text.text);
        }
        for (const PathItem& path : items_on<PathItem>(whole, "shape"))
            for (const auto& loop : path.lines) expected += area_of(loop);
        EXPECT_NEAR(area, expected, 1e-3);
        EXPECT_EQ(words.size(), 30u);
        for (int i = 0; i < 30; ++i) EXPECT_EQ(words.count("w" + std::to_string(i)), 1u);
    }
}

TEST(TilingTest, NeighboursHaveTheSameCrosses) {
    Random random(5);
    const auto pages = tiled(picture({400, 500}, random), {210, 297});
    ASSERT_TRUE(pages);
    std::map<std::string, int> numbers;  // each shared edge is named from both sides, by two crosses
    for (const Drawing& page : *pages)
        for (const TextItem& text : items_on<TextItem>(page, "tile"))
            if (std::regex_match(text.text, std::regex("[0-9]+"))) ++numbers[text.text];
    int edges = 0;
    for (const auto& entry : numbers) edges += entry.second;
    const int rows = 2, columns = 3;
    ASSERT_EQ(pages->size(), static_cast<std::size_t>(rows * columns));
    EXPECT_EQ(edges, 2 * 2 * (rows * (columns - 1) + columns * (rows - 1)));
}

TEST(TilingTest, EmptyTilesAreLeftOutAndSmallDrawingsStayWhole) {
    PageBuilder page("corner", {500, 500});
    page.layer("grid", {});
    page.line({0, 250}, {500, 250}, {});
    page.layer("shape", {});
    page.rectangle({10, 10}, {20, 20}, Color{});
    const auto pages = tiled(page.finish(), {210, 297});
    ASSERT_TRUE(pages);
    EXPECT_EQ(pages->size(), 1u);

    PageBuilder small("small", {267 - 24, 180});
    small.rectangle({0, 0}, {100, 100}, Color{});
    EXPECT_EQ(tiled(small.finish(), {210, 297})->size(), 1u) << "across";
}

TEST(TilingTest, PaperThatIsTooSmallIsRefused) {
    PageBuilder page("page", {500, 500});
    const auto pages = tiled(page.finish(), {105, 148});
    ASSERT_FALSE(pages);
    EXPECT_NE(text(pages.error().message).find("A4"), std::string::npos);
}

TEST(DrawingSvgTest, KeepsTheOrderAndEscapesWords) {
    PageBuilder page("a < b", {20, 10});
    page.layer("cut", {});
    page.rectangle({1, 2}, {3, 4}, Color{255, 0, 0});
    page.layer("notes", {});
    page.text({1, 1}, "<&>");
    page.layer("cut", {});
    page.line({0, 0}, {1.5, 1}, {{}, 0.2, {1, 2}});
    const std::string svg = drawing_svg(page.finish());
    EXPECT_NE(svg.find("width=\"20mm\" height=\"10mm\" viewBox=\"0 0 20 10\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("&lt;&amp;&gt;"), std::string::npos);
    EXPECT_NE(svg.find("M1 2L4 2L4 6L1 6Z"), std::string::npos);
    EXPECT_LT(svg.find("id=\"cut\""), svg.find("id=\"notes\""));
    EXPECT_LT(svg.find("id=\"notes\""), svg.find("id=\"cut-2\""));
    EXPECT_NE(svg.find("stroke-dasharray=\"1 2\""), std::string::npos);
}

}  // namespace
}  // namespace snug
