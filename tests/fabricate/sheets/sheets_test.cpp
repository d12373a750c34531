#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/text.h"
#include "snug/fabricate/sheets/dowel_holes.h"
#include "snug/fabricate/sheets/nesting.h"
#include "snug/fabricate/sheets/sheet_outlines.h"
#include "snug/fabricate/sheets/sheets_pack.h"
#include "snug/polygon/polygon.h"
#include "snug/space/available.h"
#include "snug/words/words.h"

#include "tests/support/sheet_foams.h"

namespace snug {
namespace {

using test::CutFoams;
using test::foams_of;
using test::l_shaped_foam;
using test::Random;
using test::random_sheet_foam;

/// Three levels of blocks, the lower two below the parting; where the map has a # the middle one is cut.
CutFoams foam_with_pits(const std::vector<std::string>& rows) {
    BlockMap map(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()));
    for (int j = 0; j < map.ny(); ++j)
        for (int k = 0; k < map.nz(); ++k)
            if (rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] == '#') map(j, k) = {1, 2};
    const Vec3i blocks{3, map.ny(), map.nz()};
    return foams_of({blocks, {10, 10, 12}}, std::move(map), 2);
}

std::string refusal(const CutFoams& foam, const SheetOptions& options) {
    const auto pack = sheets_pack(foam.design(), options);
    return pack ? "" : text(pack.error().message);
}

TEST(Sheets, OutlinesGrowAndHolesShrinkByTheKerf) {
    const CutFoams foam = foam_with_pits({"......", ".##...", ".##...", "......"});
    const auto stack = sheet_stack(foam.design(), Half::lower, {10, 1, 1});
    ASSERT_TRUE(stack);
    const SheetPiece& ring = stack->pieces.back();
    ASSERT_EQ(ring.loops.size(), 2u);
    for (const double kerf : {0.0, 0.25, 3.0}) {
        const auto outer = offset_outline(ring.loops[0], stack->cell_mm, kerf / 2);
        EXPECT_EQ(perimeter(outer), 2 * (6 * 12 + 4 * 10) + 4 * kerf);
        EXPECT_EQ(outer[0].x, -kerf / 2);
        const auto hole = offset_outline(ring.loops[1], stack->cell_mm, kerf / 2);
        EXPECT_EQ(perimeter(hole), 2 * (2 * 12 + 2 * 10) - 4 * kerf);
    }
}

TEST(Sheets, CellsThatMeetInACornerAreCutApart) {
    // A ring of pits that meet in corners: the foam within would hang on points.
    const CutFoams foam = foam_with_pits({"......", "..##..", ".#..#.", "..##..", "......"});
    const auto stack = sheet_stack(foam.design(), Half::lower, {10, 1, 1});
    ASSERT_TRUE(stack);
    ASSERT_EQ(stack->pieces.size(), 3u);
    EXPECT_EQ(stack->pieces[2].name, "L2a");
    EXPECT_EQ(stack->pieces[2].cells, 2);
    EXPECT_EQ(stack->pieces[1].loops.size(), 2u);
}

TEST(Sheets, TheLineOfTheSheetAboveLeavesOutWhatIsCutAnyway) {
    const CutFoams foam = foam_with_pits({"##....", "##....", "......"});
    const auto stack = sheet_stack(foam.design(), Half::lower, {10, 1, 1});
    ASSERT_TRUE(stack);
    const auto lines = outline_above(*stack, stack->pieces[0]);
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].size(), 3u);  // from the upper edge down, around the pit's corner, to the left edge
    EXPECT_EQ(lines[0][1].x, 24);
    EXPECT_EQ(lines[0][1].y, 20);
    EXPECT_TRUE(outline_above(*stack, stack->pieces[1]).empty());
}

TEST(Sheets, DowelsFitOneWayOnlyWhateverTheFoam) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const CutFoams foam = random_sheet_foam(random);
        SheetOptions options;
        options.dowels = random.integer(2, 6);
        options.dowel_edge_mm = random.between(0, 10);
        for (const Half half : {Half::lower, Half::lid}) {
            const auto stack = sheet_stack(foam.design(), half, {foam.space.block_mm.x, 1, 1});
            ASSERT_TRUE(stack);
            const DowelHoles holes = dowel_holes(*stack, options);
            if (holes.sheets == 0) continue;
            EXPECT_GE(holes.centres.size(), 2u);
            EXPECT_TRUE(one_way_only(holes.centres, stack->size_mm(), options.dowel_mm));
        }
    }
    EXPECT_FALSE(one_way_only({{10, 10}, {90, 50}}, {100, 60}, 6));  // the same when turned
    EXPECT_FALSE(one_way_only({{10, 30}, {50, 30}}, {100, 60}, 6));  // the same when mirrored
    EXPECT_TRUE(one_way_only({{10, 10}, {70, 50}}, {100, 60}, 6));
}

TEST(Sheets, IslandsLieInOffcutsAndSaveStock) {
    Random random(5);
    std::vector<Mask> masks;
    for (int i = 0; i < 6; ++i) {
        Mask ring(20, 16);
        for (int row = 0; row < 16; ++row)
            for (int column = 0; column < 20; ++column)
                if (row < 2 || row > 13 || column < 2 || column > 17) ring.set(column, row);
        masks.push_back(ring);
    }
    for (int i = 0; i < 40; ++i) {
        Mask island(random.integer(1, 5), random.integer(1, 5));
        for (int row = 0; row < island.height; ++row)
            for (int column = 0; column < island.width; ++column)
                if (row == 0 || column == 0) island.set(column, row);
        masks.push_back(island);
    }
    std::vector<PieceToNest> pieces;
    for (const Mask& mask : masks) {
        int cells = 0;
        for (const char cell : mask.cells) cells += cell;
        pieces.push_back({std::to_string(pieces.size()), &mask, cells});
    }
    SheetOptions options;
    options.stock_mm = {420, 900};  // two rings wide
    const auto nested = nest(pieces, {10, 12}, options), boxes = nest(pieces, {10, 12}, options, false);
    ASSERT_TRUE(nested && boxes);
    EXPECT_LT(nested->used_mm2, 0.85 * boxes->used_mm2);
    EXPECT_LE(nested->stocks, boxes->stocks);
    RecordProperty("nested_share_of_boxes", std::to_string(nested->used_mm2 / boxes->used_mm2));
}

TEST(Sheets, AnotherStockThatHoldsEverythingIsNotNeeded) {
    const auto pack = sheets_pack(l_shaped_foam().design(), {});
    ASSERT_TRUE(pack);
    const auto stocks = std::count_if(pack->files.begin(), pack->files.end(), [](const PackFile& file) {
        return file.name.starts_with("sheets/") && file.name.ends_with(".svg");
    });
    EXPECT_EQ(stocks, 1);  // six sheets of 225 x 140 mm on 1000 x 600
}

TEST(Sheets, SayWhichThicknessesWork) {
    SheetOptions options;
    options.thickness_mm = 20;
    EXPECT_NE(refusal(l_shaped_foam(), options).find("15 mm or 30 mm"), std::string::npos);
    options.thickness_mm = 10;
    EXPECT_NE(refusal(l_shaped_foam(), options).find("7.5 mm or 15 mm"), std::string::npos);
    options.thickness_mm = 90;  // thicker than either half
    EXPECT_NE(refusal(l_shaped_foam(), options).find("45 mm"), std::string::npos);
    for (const double thickness : {15.0, 7.5, 5.0, 30.0, 45.0}) {
        options.thickness_mm = thickness;
        EXPECT_EQ(refusal(l_shaped_foam(), options), "") << thickness;
    }
}

TEST(Sheets, OfNoFoamAreRefused) {
    const CutFoams nothing = foams_of({{2, 2, 2}, {10, 10, 10}}, BlockMap(2, 2, {0, 2}), 1);
    EXPECT_NE(refusal(nothing, {}).find("no foam"), std::string::npos);
}

TEST(Sheets, SayWhichStockWouldDo) {
    SheetOptions options;
    options.stock_mm = {200, 150};
    EXPECT_NE(refusal(l_shaped_foam(), options).find("at least 235 x 150 mm"), std::string::npos);
    options.stock_mm = {150, 235};
    EXPECT_EQ(refusal(l_shaped_foam(), options), "");
    options.kerf_mm = 20;
    options.dowels = 0;
    EXPECT_NE(refusal(l_shaped_foam(), options).find("kerf"), std::string::npos);
    options.kerf_mm = -1;
    EXPECT_NE(refusal(l_shaped_foam(), options).find("kerf"), std::string::npos);
}

TEST(Sheets, NameIslandsAndWhatWouldFallOut) {
    const auto pack = sheets_pack(foam_with_pits({".#.", ".#.", ".#."}).design(), {});
    ASSERT_TRUE(pack);
    EXPECT_EQ(pack->findings[0].code(), "sheets-dowels");
    bool named = false;
    for (const Finding& finding : pack->findings)
        named = named || (finding.code() == "sheets-islands" &&
                          text(finding.message).find("L2a") != std::string::npos);
    EXPECT_TRUE(named);
    BlockMap through(3, 3);
    for (int j = 0; j < 3; ++j) through(j, 1) = {0, 3};
    const auto loose = sheets_pack(foams_of({{3, 3, 3}, {10, 40, 40}}, through, 2).design(), {});
    ASSERT_TRUE(loose);
    EXPECT_EQ(std::count_if(loose->findings.begin(), loose->findings.end(),
                            [](const Finding& finding) { return finding.code() == "sheets-loose"; }),
              2);
}

TEST(Sheets, SayWhatThickSheetsLose) {
    SheetOptions options;
    options.thickness_mm = 30;
    const CutFoams foam = l_shaped_foam();
    const auto pack = sheets_pack(foam.design(), options);
    ASSERT_TRUE(pack);
    long long lost = 0;
    for (const snug::Run kept : foam.foams.piece(Half::lower)) lost += kept.end % 2;
    bool named = false;
    for (const Finding& finding : pack->findings)
        named = named ||
                (finding.code() == "sheets-lost" &&
                 text(finding.message).find(std::to_string(lost) + " blocks more from the lower foam") !=
                     std::string::npos &&
                 text(finding.message).find(grouped(static_cast<unsigned long long>(lost) * 7500) + " mm3") !=
                     std::string::npos);
    EXPECT_TRUE(named);
}

TEST(Sheets, TheAssemblyPagesShowEverySheetAndIsland) {
    const auto pack = sheets_pack(foam_with_pits({".#.#.", ".#.#.", ".#.#."}).design(), {});
    ASSERT_TRUE(pack);
    std::vector<std::string> words;
    for (const Drawing& page : pack->documents[0].pages)
        for (const DrawingItem& item : page.items)
            if (const auto* text = std::get_if<TextItem>(&item.what)) words.push_back(text->text);
    for (const std::string name : {"L1", "L2", "U1", "a", "b", "BACK"})
        EXPECT_NE(std::find(words.begin(), words.end(), name), words.end()) << name;
}

}  // namespace
}  // namespace snug
