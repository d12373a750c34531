#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/text.h"
#include "snug/fabricate/sheets/dowel_holes.h"
#include "snug/fabricate/sheets/nesting.h"
#include "snug/fabricate/sheets/sheet_outlines.h"
#include "snug/fabricate/sheets/sheets_pack.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/space/available.h"
#include "snug/words/words.h"

#include "tests/support/models.h"
#include "tests/support/random.h"
#include "tests/support/random_available.h"

namespace snug {
namespace {

namespace fs = std::filesystem;
using test::Random;

/// A foam and what it stands on.
struct Foam {
    DesignSpace space;
    BlockMap blocks;
    FoamPair foams;

    [[nodiscard]] FoamDesign design() const { return {space, blocks, foams, "a test"}; }
};

Foam foam_of(Vec3i blocks, Vec3d block_mm, BlockMap map, int parting, Grid<Run> available) {
    Foam foam{{blocks, block_mm}, std::move(map), {}};
    foam.foams = split(foam.blocks, foam.space, parting, std::move(available));
    return foam;
}
Foam foam_of(Vec3i blocks, Vec3d block_mm, BlockMap map, int parting) {
    return foam_of(blocks, block_mm, std::move(map), parting, all_blocks(blocks));
}

/// Hills, pits, lone columns and untouched ground.
Foam random_foam(Random& random, bool in_a_case = false) {
    const Vec3i blocks{random.integer(1, 9), random.integer(1, 14), random.integer(1, 14)};
    const Vec3d size{random.between(5, 30), random.between(5, 30), random.between(5, 30)};
    BlockMap map(blocks.y, blocks.z);
    const double busy = random.unit();
    for (CutRun& run : map) {
        if (!random.chance(busy)) continue;
        const int first = random.integer(0, blocks.x - 1);
        run = {static_cast<std::int16_t>(first), static_cast<std::int16_t>(random.integer(first, blocks.x))};
    }
    const int parting = random.integer(0, blocks.x);
    return foam_of(blocks, size, std::move(map), parting,
                   in_a_case ? test::random_available(random, blocks) : all_blocks(blocks));
}

/// An L seen from +x: its long stroke along z at low y, the short one downward at low z; deeper at its foot.
Foam l_shaped_foam() {
    BlockMap map(7, 9);
    for (int k = 2; k < 7; ++k) map(1, k) = {2, 5};
    for (int j = 2; j < 5; ++j) map(j, 2) = {1, 4};
    return foam_of({6, 7, 9}, {15, 20, 25}, std::move(map), 3);
}

/// In the default space, the object as long as is usual for it.
Foam packed(Mesh mesh) {
    Design design;
    design.object.longest_mm = 200;
    const auto object = prepare(std::move(mesh), design);
    const auto packing = pack(*object, design);
    return {packing->space, packing->blocks, *packing->foams};
}

int highest(const Foam& foam, Half half) {
    const auto& heights = foam.foams.heights(half);
    return *std::max_element(heights.begin(), heights.end());
}

SheetOptions options_with(double kerf) {
    SheetOptions options;
    options.kerf_mm = kerf;
    return options;
}

class SheetFiles : public testing::Test {
  protected:
    SheetFiles() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / ("snug-" + std::string(test->name()) + "-" +
                                               std::to_string(reinterpret_cast<std::uintptr_t>(this)));
        fs::create_directories(folder_);
    }
    ~SheetFiles() override { fs::remove_all(folder_); }

    /// Writes the pack as a case for the reader.
    void add(const Foam& foam, const SheetOptions& options) {
        const auto pack = sheets_pack(foam.design(), options);
        ASSERT_TRUE(pack) << text(pack.error().message);
        const fs::path folder = folder_ / std::to_string(cases_.size());
        fs::create_directories(folder / "sheets");
        for (const PackFile& file : pack->files) {
            std::ofstream out(folder / file.name, std::ios::binary);
            out.write(reinterpret_cast<const char*>(file.bytes.data()),
                      static_cast<std::streamsize>(file.bytes.size()));
        }
        const Vec3d block = foam.space.block_mm;
        std::string line = std::to_string(foam.space.blocks.y) + "," + std::to_string(foam.space.blocks.z);
        for (const double value : {block.y, block.z, options.kerf_mm, options.spacing_mm, options.margin_mm,
                                   options.dowel_mm, options.dowel_edge_mm})
            line += "," + number(value, 9);
        std::ofstream(folder / "case.csv") << line;
        cases_.push_back({foam.foams, options.thickness_mm.value_or(block.x) / block.x, foam.space.blocks.x});
    }

    /// Every column that the files describe is the design's.
    void expect_the_same_foams() {
        std::string command = "python3 " SNUG_SOURCE_DIR "/tests/support/read_sheets.py";
        for (std::size_t i = 0; i < cases_.size(); ++i)
            command += " " + (folder_ / std::to_string(i)).string();
        ASSERT_EQ(std::system(command.c_str()), 0);
        for (std::size_t i = 0; i < cases_.size(); ++i) {
            SCOPED_TRACE("case " + std::to_string(i));
            std::ifstream in(folder_ / std::to_string(i) / "rebuilt.csv");
            std::string half, j, k, first, end;
            std::size_t columns = 0;
            while (std::getline(in, half, ',') && std::getline(in, j, ',') && std::getline(in, k, ',') &&
                   std::getline(in, first, ',') && std::getline(in, end)) {
                const FoamPair& foams = cases_[i].foams;
                const auto kept = kept_run(foams, half == "lower" ? Half::lower : Half::lid,
                                           foams.lower.index(std::stoi(j), std::stoi(k)), cases_[i].nx);
                const double levels = cases_[i].levels;
                const int many = static_cast<int>((levels >= 1 ? levels : 1 / levels) + 0.5);
                const int wanted_first = levels >= 1 ? (kept.first + many - 1) / many : kept.first * many;
                const int wanted_end = levels >= 1 ? kept.end / many : kept.end * many;
                const bool none = wanted_first >= wanted_end;
                ASSERT_EQ(std::stoi(first), none ? 0 : wanted_first) << half << " " << j << " " << k;
                ASSERT_EQ(std::stoi(end), none ? 0 : wanted_end) << half << " " << j << " " << k;
                ++columns;
            }
            EXPECT_EQ(columns, cases_[i].foams.lower.size() + cases_[i].foams.upper.size());
        }
    }

  private:
    struct Case {
        FoamPair foams;
        double levels;
        int nx;
    };
    fs::path folder_;
    std::vector<Case> cases_;
};

TEST_F(SheetFiles, GiveRandomFoamsBack) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Foam foam = random_foam(random, seed > 16);
        SheetOptions options = options_with(random.chance(0.5) ? 0 : random.between(0.05, 4));
        options.spacing_mm = random.chance(0.2) ? 0.5 : random.between(1, 12);
        options.dowel_mm = random.between(4.5, 7);
        options.dowel_edge_mm = random.between(0, 6);
        options.dowels = random.integer(2, 5);
        if (random.chance(0.2)) options.thickness_mm = foam.space.block_mm.x / random.integer(2, 3);
        if (seed > 16 && random.chance(0.3) &&
            std::max(highest(foam, Half::lower), highest(foam, Half::lid)) > 1)
            options.thickness_mm = foam.space.block_mm.x * 2;
        if (seed > 16 && !sheets_pack(foam.design(), options)) continue;  // no foam is left
        add(foam, options);
    }
    expect_the_same_foams();
}

TEST_F(SheetFiles, MirrorNothing) {
    add(l_shaped_foam(), options_with(0));
    add(l_shaped_foam(), options_with(0.4));
    expect_the_same_foams();
}

TEST_F(SheetFiles, GiveTheFoamsOfSamplesBack) {
    for (const std::string_view name : sample_names()) add(packed(*sample(name)), options_with(0.2));
    expect_the_same_foams();
}

TEST_F(SheetFiles, GiveTheFoamsOfScansBack) {
    for (const std::string name : {"spot.obj", "screwdriver.off", "teapot.obj", "stanford-bunny.obj"}) {
        const auto bytes = test::model_file(name);
        if (!bytes) GTEST_SKIP() << "the shared objects are not here";
        const auto mesh = read_mesh(*bytes, name);
        ASSERT_TRUE(mesh) << text(mesh.error().message);
        add(packed(*mesh), options_with(0));
    }
    expect_the_same_foams();
}

TEST_F(SheetFiles, OfThickSheetsTakeTheUnionOfTheirCuts) {
    SheetOptions options;
    options.thickness_mm = 30;
    add(l_shaped_foam(), options);
    expect_the_same_foams();
}

/// Three levels of blocks, the lower two below the parting; where the map has a # the middle one is cut.
Foam foam_with_pits(const std::vector<std::string>& rows) {
    BlockMap map(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()));
    for (int j = 0; j < map.ny(); ++j)
        for (int k = 0; k < map.nz(); ++k)
            if (rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] == '#') map(j, k) = {1, 2};
    const Vec3i blocks{3, map.ny(), map.nz()};
    return foam_of(blocks, {10, 10, 12}, std::move(map), 2);
}

std::string refusal(const Foam& foam, const SheetOptions& options) {
    const auto pack = sheets_pack(foam.design(), options);
    return pack ? "" : text(pack.error().message);
}

TEST(Sheets, OutlinesGrowAndHolesShrinkByTheKerf) {
    const Foam foam = foam_with_pits({"......", ".##...", ".##...", "......"});
    const auto stack = sheet_stack(foam.design(), Half::lower, {10, 1, 1});
    ASSERT_TRUE(stack);
    const SheetPiece& ring = stack->pieces.back();
    ASSERT_EQ(ring.loops.size(), 2u);
    for (const double kerf : {0.0, 0.25, 3.0}) {
        const auto outer = cut_line(ring.loops[0], stack->cell_mm, kerf);
        EXPECT_EQ(loop_length(outer), 2 * (6 * 12 + 4 * 10) + 4 * kerf);
        EXPECT_EQ(outer[0].x, -kerf / 2);
        const auto hole = cut_line(ring.loops[1], stack->cell_mm, kerf);
        EXPECT_EQ(loop_length(hole), 2 * (2 * 12 + 2 * 10) - 4 * kerf);
    }
}

TEST(Sheets, CellsThatMeetInACornerAreCutApart) {
    // A ring of pits that meet in corners: the foam within would hang on points.
    const Foam foam = foam_with_pits({"......", "..##..", ".#..#.", "..##..", "......"});
    const auto stack = sheet_stack(foam.design(), Half::lower, {10, 1, 1});
    ASSERT_TRUE(stack);
    ASSERT_EQ(stack->pieces.size(), 3u);
    EXPECT_EQ(stack->pieces[2].name, "L2a");
    EXPECT_EQ(stack->pieces[2].cells, 2);
    EXPECT_EQ(stack->pieces[1].loops.size(), 2u);
}

TEST(Sheets, TheLineOfTheSheetAboveLeavesOutWhatIsCutAnyway) {
    const Foam foam = foam_with_pits({"##....", "##....", "......"});
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
        const Foam foam = random_foam(random);
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
    const Foam nothing = foam_of({2, 2, 2}, {10, 10, 10}, BlockMap(2, 2, {0, 2}), 1);
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
    const auto loose = sheets_pack(foam_of({3, 3, 3}, {10, 40, 40}, through, 2).design(), {});
    ASSERT_TRUE(loose);
    EXPECT_EQ(std::count_if(loose->findings.begin(), loose->findings.end(),
                            [](const Finding& finding) { return finding.code() == "sheets-loose"; }),
              2);
}

TEST(Sheets, SayWhatThickSheetsLose) {
    SheetOptions options;
    options.thickness_mm = 30;
    const Foam foam = l_shaped_foam();
    const auto pack = sheets_pack(foam.design(), options);
    ASSERT_TRUE(pack);
    long long lost = 0;
    for (const auto blocks : foam.foams.lower) lost += blocks % 2;
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
