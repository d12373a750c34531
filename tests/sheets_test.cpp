#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/text.h"
#include "snug/fabricate/dowel_holes.h"
#include "snug/fabricate/sheet_outlines.h"
#include "snug/fabricate/sheets_pack.h"
#include "snug/mesh/read.h"
#include "snug/mesh/samples.h"
#include "snug/pipeline.h"

#include "tests/support/models.h"
#include "tests/support/random.h"

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

Foam foam_of(Vec3i blocks, Vec3d block_mm, BlockMap map, int parting) {
    Foam foam{{blocks, block_mm}, std::move(map), {}};
    foam.foams = split(foam.blocks, foam.space, parting);
    return foam;
}

/// Hills, pits, lone columns and untouched ground.
Foam random_foam(Random& random) {
    const Vec3i blocks{random.integer(1, 9), random.integer(1, 14), random.integer(1, 14)};
    const Vec3d size{random.between(5, 30), random.between(5, 30), random.between(5, 30)};
    BlockMap map(blocks.y, blocks.z);
    const double busy = random.unit();
    for (CutRun& run : map) {
        if (!random.chance(busy)) continue;
        const int first = random.integer(0, blocks.x - 1);
        run = {static_cast<std::int16_t>(first), static_cast<std::int16_t>(random.integer(first, blocks.x))};
    }
    return foam_of(blocks, size, std::move(map), random.integer(0, blocks.x));
}

/// An L seen from +x: its long stroke along z at low y, the short one downward at low z; deeper at its foot.
Foam l_shaped_foam() {
    BlockMap map(7, 9);
    for (int k = 2; k < 7; ++k) map(1, k) = {2, 5};
    for (int j = 2; j < 5; ++j) map(j, 2) = {1, 4};
    return foam_of({6, 7, 9}, {15, 20, 25}, std::move(map), 3);
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
        ASSERT_TRUE(pack) << pack.error().message;
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
        cases_.push_back({foam.foams, options.thickness_mm.value_or(block.x) / block.x});
    }

    /// Every column that the files describe is the design's.
    void expect_the_same_foams() {
        std::string command = "python3 " SNUG_SOURCE_DIR "/tests/read_sheets.py";
        for (std::size_t i = 0; i < cases_.size(); ++i)
            command += " " + (folder_ / std::to_string(i)).string();
        ASSERT_EQ(std::system(command.c_str()), 0);
        for (std::size_t i = 0; i < cases_.size(); ++i) {
            SCOPED_TRACE("case " + std::to_string(i));
            std::ifstream in(folder_ / std::to_string(i) / "rebuilt.csv");
            std::string half, j, k, sheets;
            std::size_t columns = 0;
            while (std::getline(in, half, ',') && std::getline(in, j, ',') && std::getline(in, k, ',') &&
                   std::getline(in, sheets)) {
                const auto& kept = half == "lower" ? cases_[i].foams.lower : cases_[i].foams.upper;
                const double levels = cases_[i].levels;
                const int blocks = kept(std::stoi(j), std::stoi(k));
                const int wanted =
                    static_cast<int>(levels >= 1 ? blocks / static_cast<int>(levels + 0.5)
                                                 : blocks * static_cast<int>(1 / levels + 0.5));
                ASSERT_EQ(std::stoi(sheets), wanted) << half << " " << j << " " << k;
                ++columns;
            }
            EXPECT_EQ(columns, cases_[i].foams.lower.size() + cases_[i].foams.upper.size());
        }
    }

  private:
    struct Case {
        FoamPair foams;
        double levels;
    };
    fs::path folder_;
    std::vector<Case> cases_;
};

TEST_F(SheetFiles, GiveRandomFoamsBack) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Foam foam = random_foam(random);
        SheetOptions options = options_with(random.chance(0.5) ? 0 : random.between(0.05, 4));
        options.spacing_mm = random.chance(0.2) ? 0.5 : random.between(1, 12);
        options.dowel_mm = random.between(4.5, 7);
        options.dowel_edge_mm = random.between(0, 6);
        options.dowels = random.integer(2, 5);
        if (random.chance(0.2)) options.thickness_mm = foam.space.block_mm.x / random.integer(2, 3);
        add(foam, options);
    }
    expect_the_same_foams();
}

TEST_F(SheetFiles, MirrorNothing) {
    add(l_shaped_foam(), options_with(0));
    add(l_shaped_foam(), options_with(0.4));
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
