#include "snug/fabricate/sponge/sponge.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <regex>

#include <gtest/gtest.h>

#include "snug/base/stopwatch.h"
#include "snug/depth/depth_map.h"
#include "snug/drawing/drawing_svg.h"
#include "snug/fabricate/kit/block_names.h"
#include "snug/fabricate/kit/finger_room.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/sponge/pluck_map.h"
#include "snug/fabricate/sponge/pluck_plan.h"
#include "snug/fabricate/sponge/sponge_plan.h"
#include "snug/space/available.h"
#include "snug/words/words.h"

#include "tests/support/cut_foams.h"
#include "tests/support/drawing_cells.h"
#include "tests/support/random.h"
#include "tests/support/random_available.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::CutFoams;
using test::foams_of;
using test::Random;
using test::random_foams;
using test::read_map;
using test::ReadMap;

/// What is left of each column (j, k) of a half, level by level from the case's side ('#' foam, '.' none), as
/// someone finds it who plucks and cuts off what the maps show.
Grid<std::string> worked(const CutFoams& foams, Half half) {
    const PluckPlan plan = pluck_plan(foams.design(), half);
    const int ny = foams.space.blocks.y, nz = foams.space.blocks.z;
    Grid<std::string> left(ny, nz, std::string(static_cast<std::size_t>(plan.layers), '#'));
    long long plucked = 0, cut_off = 0;
    for (const LayerRun& run : plan.runs) {
        const Drawing drawing = pluck_map(plan, run, foams.design());
        ReadMap map = read_map(drawing, "pluck", ny, nz);
        EXPECT_EQ(static_cast<long long>(map.cells.size()), run.plucked);
        if (run.cut_off > 0) {
            const ReadMap off = read_map(drawing, "cut-off", ny, nz);
            EXPECT_EQ(static_cast<long long>(off.cells.size()), run.cut_off);
            for (const auto& cell : off.cells)
                EXPECT_TRUE(map.cells.insert(cell).second) << "a block that is not there is plucked";
        }
        for (const auto& [row, column] : map.cells)
            for (int layer = run.first; layer <= run.last; ++layer)
                left(half == Half::lower ? row : ny - 1 - row,
                     column)[static_cast<std::size_t>(plan.layers - layer)] = '.';
        plucked += run.plucked * run.layers();
        cut_off += run.cut_off * run.layers();
    }
    EXPECT_EQ(plucked, plan.plucked);
    EXPECT_EQ(cut_off, plan.cut_off);
    return left;
}

/// The same of a run of blocks that is kept.
std::string column_of(Run kept, std::size_t layers) {
    std::string column(layers, '.');
    for (int i = kept.first; i < kept.end; ++i) column[static_cast<std::size_t>(i)] = '#';
    return column;
}

TEST(SpongeTest, WhoPlucksWhatTheMapsShowHasTheFoams) {
    int cut_off = 0;
    for (int seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const CutFoams foams = random_foams(random, seed >= 60);
        for (const Half half : {Half::lower, Half::lid}) {
            const Grid<std::string> left = worked(foams, half);
            const Grid<snug::Run> kept = kept_runs(foams.foams, half, foams.space.blocks.x);
            for (std::size_t column = 0; column < left.size(); ++column)
                ASSERT_EQ(left[column], column_of(kept[column], left[column].size()));
            cut_off += pluck_plan(foams.design(), half).cut_off > 0;
        }
    }
    EXPECT_GT(cut_off, 60);
}

TEST(SpongeTest, WhatACaseHasNoRoomForIsCutOffAndNeverCountedAsPlucked) {
    // A column beside a leaning wall keeps two of four levels; the lid's is whole.
    auto available = all_blocks({6, 1, 2});
    available(0, 1).first = 2;
    const CutFoams foams = foams_of({{6, 1, 2}, {10, 10, 10}}, BlockMap(1, 2), 4, available);
    const PluckPlan plan = pluck_plan(foams.design(), Half::lower);
    EXPECT_EQ(plan.plucked, 0);
    EXPECT_EQ(plan.cut_off, 2);
    const auto pack = sponge_pack(foams.design(), {});
    ASSERT_TRUE(pack);
    EXPECT_EQ(pack->material.pieces, 0);
    ASSERT_FALSE(pack->findings.empty());
    EXPECT_EQ(pack->findings.front().code(), "cut_off");
    EXPECT_NE(text(pack->findings.front().message).find("2 blocks"), std::string::npos);
    ASSERT_FALSE(pack->files.empty());
    EXPECT_EQ(pack->files.front().name, "sponge/lower-03-04.svg");
}

TEST(SpongeTest, PluckedBlocksAreTheCutOnesAndWhatBothHalvesHaveTooMuch) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const CutFoams foams = random_foams(random);
        const PluckPlan lower = pluck_plan(foams.design(), Half::lower),
                        lid = pluck_plan(foams.design(), Half::lid);
        const long long columns = 1LL * foams.space.blocks.y * foams.space.blocks.z;
        const long long overlap = (lower.layers + lid.layers - foams.space.blocks.x) * columns;
        EXPECT_EQ(lower.plucked + lid.plucked, foams.cut() + overlap);
    }
}

TEST(SpongeTest, LayersNestSoThatWorkGoesDownward) {
    Random random(7);
    const CutFoams foams = random_foams(random);
    const PluckPlan plan = pluck_plan(foams.design(), Half::lower);
    ASSERT_FALSE(plan.runs.empty());
    EXPECT_EQ(plan.runs.front().first, 1);
    EXPECT_EQ(plan.runs.back().last, plan.layers);
    for (std::size_t i = 1; i < plan.runs.size(); ++i) {
        EXPECT_EQ(plan.runs[i].first, plan.runs[i - 1].last + 1);
        EXPECT_LT(plan.runs[i].plucked, plan.runs[i - 1].plucked);
    }
}

/// An L in the y-z plane, cut four blocks deep into either half:
///   BACK  X . . .
///         X . . .
///         X X X .
CutFoams letter_l() {
    const DesignSpace space{{8, 3, 4}, {15, 15, 22}};
    BlockMap blocks(3, 4);
    for (const auto& [j, k] : {std::pair(0, 0), {1, 0}, {2, 0}, {2, 1}, {2, 2}}) blocks(j, k) = {2, 6};
    return foams_of(space, std::move(blocks), 4);
}

TEST(SpongeTest, MapsFoldedAlongBackMeet) {
    const CutFoams foams = letter_l();
    const PluckPlan lower = pluck_plan(foams.design(), Half::lower),
                    lid = pluck_plan(foams.design(), Half::lid);
    const ReadMap below = read_map(pluck_map(lower, lower.runs[0], foams.design()), "pluck", 3, 4);
    const ReadMap above = read_map(pluck_map(lid, lid.runs[0], foams.design()), "pluck", 3, 4);
    // Seen from +x with BACK on top, k to the right.
    EXPECT_EQ(below.cells, (std::set<std::pair<int, int>>{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}));
    // The lid's map lies with its BACK against the lower one's, above it. Folded over, row by row from BACK,
    // each hole lies on its own.
    std::set<std::pair<int, int>> folded;
    for (const auto& [row, column] : above.cells) folded.insert({3 - 1 - row, column});
    EXPECT_EQ(folded, below.cells);
    EXPECT_NE(above.cells, below.cells) << "an unfolded copy would be a mirrored lid";
    EXPECT_DOUBLE_EQ(below.size.x, 4 * 22);
    EXPECT_DOUBLE_EQ(below.size.y, 3 * 15);
}

/// Where on the sheet a word stands, from the foam's corner.
Vec2d place_of(const Drawing& drawing, const std::string& word) {
    const ReadMap map = read_map(drawing, "pluck", 1, 1);
    for (const char* layer : {"notes", "edge"})
        for (const TextItem& text : test::items_on<TextItem>(drawing, layer))
            if (text.text == word) return text.at - map.corner;
    ADD_FAILURE() << "no " << word;
    return {};
}

TEST(SpongeTest, EverySheetSaysWhichWayRound) {
    const CutFoams foams = letter_l();
    for (const Half half : {Half::lower, Half::lid}) {
        const PluckPlan plan = pluck_plan(foams.design(), half);
        const bool lower = half == Half::lower;
        for (const Drawing& sheet : {pluck_map(plan, plan.runs[0], foams.design()),
                                     pluck_overview(plan, {210, 297}, foams.design())}) {
            std::string all;
            for (const TextItem& text : test::items_on<TextItem>(sheet, "notes")) all += text.text + "\n";
            EXPECT_NE(all.find(lower ? "LOWER" : "LID"), std::string::npos);
            EXPECT_TRUE(std::regex_search(all, std::regex("[Cc]avity facing you"))) << all;
            const ReadMap map = read_map(sheet, "pluck", 3, 4);
            const double back = place_of(sheet, "BACK").y;
            EXPECT_TRUE(lower ? back < 0 : back > map.size.y) << "BACK stands at its edge";
            // Row A lies at BACK and column 1 to the left, in both halves; so does the odd corner.
            EXPECT_EQ(place_of(sheet, "A").y < place_of(sheet, "C").y, lower);
            EXPECT_LT(place_of(sheet, "1").x, place_of(sheet, "4").x);
            const auto edges = test::items_on<PathItem>(sheet, "edge");
            const auto odd = std::find_if(edges.begin(), edges.end(),
                                          [](const PathItem& e) { return e.fill.has_value(); });
            ASSERT_NE(odd, edges.end());
            const Vec2d corner = odd->lines[0][0] - map.corner;
            EXPECT_NEAR(corner.x, 0, 1e-9);
            EXPECT_NEAR(corner.y, lower ? 0 : map.size.y, 1e-9);
        }
    }
}

TEST(SpongeTest, TheOverviewCountsTheBlocksToRemove) {
    for (int seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(100 + seed));
        const CutFoams foams = random_foams(random);
        const PluckPlan plan = pluck_plan(foams.design(), random.chance(0.5) ? Half::lower : Half::lid);
        const Drawing sheet = pluck_overview(plan, {210, 297}, foams.design());
        if (!overview_has_numbers(plan, {210, 297})) continue;
        const int rows = plan.removed.ny(), columns = plan.removed.nz();
        const ReadMap map = read_map(sheet, "pluck", rows, columns);
        Grid<int> read(rows, columns, 0);
        for (const TextItem& text : test::items_on<TextItem>(sheet, "pluck")) {
            const Vec2d at = text.at - map.corner;
            read(static_cast<int>(at.y / map.size.y * rows), static_cast<int>(at.x / map.size.x * columns)) =
                std::stoi(text.text);
        }
        for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], plan.removed[i]);
        EXPECT_GE(map.corner.x, 0);
        EXPECT_LE(map.corner.x + map.size.x, sheet.size_mm.x);
        EXPECT_LE(map.corner.y + map.size.y, sheet.size_mm.y);
    }
}

/// A bowl in a grid far too fine for numbers.
CutFoams large_bowl() {
    const DesignSpace space{{300, 180, 180}, {1, 1, 1}};
    BlockMap blocks(180, 180);
    for (int j = 0; j < 180; ++j)
        for (int k = 0; k < 180; ++k) {
            const double r2 = (j - 89.5) * (j - 89.5) + (k - 80) * (k - 80);
            if (r2 >= 70 * 70) continue;
            const int deep = static_cast<int>(std::sqrt(70 * 70 - r2));
            blocks(j, k) = {static_cast<std::int16_t>(150 - deep), static_cast<std::int16_t>(150 + deep)};
        }
    return foams_of(space, std::move(blocks), 150);
}

TEST(SpongeTest, FineGridsGetATableThatSaysTheSame) {
    const CutFoams foams = large_bowl();
    const SpongeWork work{{pluck_plan(foams.design(), Half::lower), pluck_plan(foams.design(), Half::lid)},
                          fit_tests(foams.design())};
    ASSERT_FALSE(overview_has_numbers(work.plans.front(), {210, 297}));
    const std::vector<Drawing> pages = sponge_plan(foams.design(), work, {210, 297});
    std::map<std::string, Grid<int>> read;
    for (const char* half : {"LOWER: depths", "LID: depths"}) read.emplace(half, Grid<int>(180, 180, 0));
    const std::regex entry("([0-9]+)(-([0-9]+))?:\u00a0([0-9]+)");
    for (const Drawing& page : pages) {
        Grid<int>* grid = nullptr;
        int row = -1, last_row = -1;
        for (const TextItem& text : test::items_on<TextItem>(page, "notes")) {
            if (const auto found = read.find(text.text); found != read.end()) grid = &found->second;
            for (int j = 0; j < 180 && text.bold; ++j) {
                if (row_name(j) == text.text.substr(0, text.text.find('-'))) row = j;
                if (row_name(j) == text.text.substr(text.text.find('-') + 1)) last_row = j;
            }
            if (!grid || row < 0 || text.bold) continue;
            const std::string words = text.text;
            for (std::sregex_iterator at(words.begin(), words.end(), entry), end; at != end; ++at) {
                const int first = std::stoi((*at)[1]), last = (*at)[3].matched ? std::stoi((*at)[3]) : first;
                for (int j = row; j <= last_row; ++j)
                    for (int k = first; k <= last; ++k) (*grid)(j, k - 1) = std::stoi((*at)[4]);
            }
        }
    }
    for (int j = 0; j < 180; ++j)
        for (int k = 0; k < 180; ++k) {
            EXPECT_EQ(read.at("LOWER: depths")(j, k), work.plans[0].removed(j, k)) << row_name(j) << k + 1;
            EXPECT_EQ(read.at("LID: depths")(j, k), work.plans[1].removed(179 - j, k));
        }
}

TEST(SpongeTest, RowNamesAreThoseOfASpreadsheet) {
    EXPECT_EQ(row_name(0), "A");
    EXPECT_EQ(row_name(25), "Z");
    EXPECT_EQ(row_name(26), "AA");
    EXPECT_EQ(row_name(26 + 26 * 26), "AAA");
    std::set<std::string> all;
    for (int i = 0; i < 4096; ++i) all.insert(row_name(i));
    EXPECT_EQ(all.size(), 4096u);
}

TEST(SpongePackTest, EveryLayerThatIsPluckedHasItsFile) {
    Random random(3);
    const CutFoams foams = letter_l();
    const auto pack = sponge_pack(foams.design(), {});
    ASSERT_TRUE(pack);
    std::set<std::string> names;
    for (const PackFile& file : pack->files) names.insert(file.name);
    EXPECT_EQ(names, (std::set<std::string>{"sponge/fit-test.svg", "sponge/lower-01-02.svg",
                                            "sponge/lid-01-02.svg"}));
    EXPECT_EQ(pack->material.pieces, 20);
    EXPECT_NEAR(*pack->material.litres, 8 * 3 * 4 * 15 * 15 * 22 * 1e-6, 1e-9);
}

TEST(SpongePackTest, MapsAreTiledPlottedOrLeftOut) {
    const CutFoams foams = letter_l();
    const auto with = [&](MapSheets maps) {
        WorkshopOptions options;
        options.sponge.maps = maps;
        return sponge_pack(foams.design(), options).value();
    };
    const WorkshopPack tiled = with(MapSheets::tiles), plotted = with(MapSheets::plotter),
                       none = with(MapSheets::none);
    ASSERT_EQ(plotted.documents.size(), 2u);
    EXPECT_EQ(tiled.files.size(), plotted.files.size());
    // After the page that tells how to print: each map whole, as its file has it.
    ASSERT_EQ(plotted.documents[1].pages.size(), plotted.files.size() + 1);
    for (std::size_t i = 0; i < plotted.files.size(); ++i) {
        const std::string svg = drawing_svg(plotted.documents[1].pages[i + 1]);
        const auto& bytes = plotted.files[i].bytes;
        EXPECT_EQ(svg, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    }
    EXPECT_EQ(none.documents.size(), 1u);
    EXPECT_TRUE(none.files.empty());
    EXPECT_EQ(none.material.pieces, tiled.material.pieces);
}

TEST(SpongePackTest, FoamsThatNothingTouchesNeedNoPlucking) {
    const CutFoams foams = foams_of({{4, 3, 3}, {10, 10, 10}}, BlockMap(3, 3), 2);
    const auto pack = sponge_pack(foams.design(), {});
    ASSERT_TRUE(pack);
    EXPECT_TRUE(pack->files.empty());
    EXPECT_EQ(pack->material.pieces, 0);
    const auto all_lid = sponge_pack(foams_of({{4, 3, 3}, {10, 10, 10}}, BlockMap(3, 3), 0).design(), {});
    ASSERT_TRUE(all_lid);
    EXPECT_EQ(all_lid->material.pieces, 0);
}

}  // namespace
}  // namespace snug
