#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/text.h"
#include "snug/fabricate/sheets/sheets_pack.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/heights.h"
#include "tests/support/models.h"
#include "tests/support/sheet_foams.h"

// What an independent reader makes of a pack's sheets.

namespace snug {
namespace {

namespace fs = std::filesystem;
using test::CutFoams;
using test::l_shaped_foam;
using test::Random;
using test::random_sheet_foam;

/// In the default space, the object as long as is usual for it.
CutFoams packed(Mesh mesh) {
    Design design;
    design.object.longest_mm = 200;
    const auto object = prepare(std::move(mesh), design);
    const auto packing = pack(*object, design);
    return {packing->space, packing->layers.front(), *packing->foams, packing->available};
}

int highest(const CutFoams& foam, Half half) {
    const test::Heights heights = test::heights_of(foam.foams, half, foam.space.blocks.x);
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
    void add(const CutFoams& foam, const SheetOptions& options) {
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
            const auto lower = kept_runs(cases_[i].foams, Half::lower, cases_[i].nx),
                       lid = kept_runs(cases_[i].foams, Half::lid, cases_[i].nx);
            while (std::getline(in, half, ',') && std::getline(in, j, ',') && std::getline(in, k, ',') &&
                   std::getline(in, first, ',') && std::getline(in, end)) {
                const snug::Run kept = (half == "lower" ? lower : lid)(std::stoi(j), std::stoi(k));
                const double levels = cases_[i].levels;
                const int many = static_cast<int>((levels >= 1 ? levels : 1 / levels) + 0.5);
                const int wanted_first = levels >= 1 ? (kept.first + many - 1) / many : kept.first * many;
                const int wanted_end = levels >= 1 ? kept.end / many : kept.end * many;
                const bool none = wanted_first >= wanted_end;
                ASSERT_EQ(std::stoi(first), none ? 0 : wanted_first) << half << " " << j << " " << k;
                ASSERT_EQ(std::stoi(end), none ? 0 : wanted_end) << half << " " << j << " " << k;
                ++columns;
            }
            EXPECT_EQ(columns, lower.size() + lid.size());
        }
    }

  private:
    struct Case {
        Foams foams;
        double levels;
        int nx;
    };
    fs::path folder_;
    std::vector<Case> cases_;
};

TEST_F(SheetFiles, GiveRandomFoamsBack) {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(test::cases(40, 8)); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const CutFoams foam = random_sheet_foam(random, seed > 16);
        SheetOptions options = options_with(random.chance(0.5) ? 0 : random.between(0.05, 4));
        options.spacing_mm = random.chance(0.2) ? 0.5 : random.between(1, 12);
        options.dowel_mm = random.between(4.5, 7);
        options.dowel_edge_mm = random.between(0, 6);
        options.dowels = random.integer(2, 5);
        if (random.chance(0.2)) options.thickness_mm = foam.space.block_mm.x / random.integer(2, 3);
        if (seed > 16 && random.chance(0.3) &&
            std::max(highest(foam, Half::lower), highest(foam, Half::lid)) > 1)
            options.thickness_mm = foam.space.block_mm.x * 2;
        options.second_color = random.chance(0.3);
        if (random.chance(0.3)) options.liner_slit_mm = random.between(10, 30);
        if (random.chance(0.3)) options.copies = random.integer(2, 4);
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

}  // namespace
}  // namespace snug
