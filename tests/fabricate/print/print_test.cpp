#include "snug/fabricate/print/print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/printing/print_joints.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/print_design.h"
#include "tests/support/printed_checks.h"
#include "tests/support/printed_files.h"
#include "tests/support/random_available.h"

namespace snug {
namespace {

using test::Heights;

const PackContainer* find(const WorkshopPack& pack, const std::string& name) {
    for (const PackContainer& container : pack.containers)
        if (container.name == name) return &container;
    return nullptr;
}

/// Where a lattice point of a half (levels from its floor, j and k, in mm) lies on the bed by design.md.
Vec3d seen_from_the_cavity(Vec3d p, bool lid) {
    return {p.z, lid ? p.y : -p.y, p.x};
}

/// Rebuilds one half from the files: every block's centre is asked of every part. Needs one part for a half.
void expect_blocks(const test::PrintedItem& item, const Heights& heights, const DesignSpace& space,
                   bool lid) {
    const Box3d box = test::bounds_of(item);
    const Vec3d s = space.block_mm;
    const double back = lid ? 0 : heights.ny() * s.y;
    for (int j = 0; j < heights.ny(); ++j)
        for (int k = 0; k < heights.nz(); ++k)
            for (int i = 0; i < space.blocks.x; ++i) {
                const Vec3d centre{(i + 0.487) * s.x, (j + 0.513) * s.y, (k + 0.479) * s.z};
                const Vec3d on_bed = seen_from_the_cavity(centre, lid) + Vec3d{0, back, 0} + box.min;
                ASSERT_EQ(test::winding(item, on_bed), i < heights(j, k) ? 1 : 0)
                    << i << " " << j << " " << k;
            }
}

/// An L in a full frame, so that each mirror image differs.
TEST(PrintPack, AnLIsNotMirroredInEitherHalf) {
    const DesignSpace space{{6, 7, 8}, {5, 6, 7}};
    Heights lower = test::filled(7, 8, 3), upper = test::filled(7, 8, 3);
    for (int j = 1; j < 6; ++j) lower(j, 1) = upper(j, 1) = 1;
    for (int k = 1; k < 5; ++k) lower(5, k) = upper(5, k) = 2;
    const test::PrintDesign design(space, lower, upper);
    const auto pack = print_pack(design.view(), {});
    ASSERT_TRUE(pack.has_value());
    const PackContainer* bed = find(*pack, "print/bed-01.3mf");
    ASSERT_NE(bed, nullptr);
    const auto items = test::read_printed(*bed);
    ASSERT_EQ(items.size(), 2u);
    EXPECT_EQ(items[0].name, "lower-01");
    EXPECT_EQ(items[1].name, "lid-01");
    test::expect_on_bed(items, PrintOptions{}.bed_mm);
    for (const auto& item : items) test::expect_closed(item);
    expect_blocks(items[0], lower, space, false);
    expect_blocks(items[1], upper, space, true);
}

double cubic_mm(const std::vector<test::PrintedItem>& items, const std::string& prefix) {
    double volume = 0;
    for (const auto& item : items)
        if (item.name.rfind(prefix, 0) == 0) volume += test::signed_volume(item.vertices, item.triangles);
    return volume;
}

TEST(PrintPack, AnyFoamOnAnyBedIsClosedOnTheBedAndWhole) {
    int packs = 0;
    const auto seeds = static_cast<std::uint64_t>(test::cases(100));
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        test::PrintDesign design = test::random_print_design(random);
        const PrintOptions options = test::random_print_options(random);
        const int nx = design.space.blocks.x;
        if (seed % 5 > 2) design.shorten(test::random_available(random, design.space.blocks));
        const auto pack = print_pack(design.view(), options);
        if (!pack) {
            EXPECT_FALSE(text(pack.error().message).empty());
            continue;
        }
        ++packs;
        std::vector<test::PrintedItem> all;
        for (const PackContainer& container : pack->containers) {
            if (container.name.find("bed-") == std::string::npos) continue;
            auto items = test::read_printed(container);
            test::expect_on_bed(items, options.bed_mm);
            all.insert(all.end(), items.begin(), items.end());
        }
        for (const auto& item : all) test::expect_closed(item);
        const auto dowels =
            std::count_if(all.begin(), all.end(), [](const auto& i) { return i.name == "dowel"; });
        const auto blocks = [&](Half half) {
            int count = 0;
            for (const auto run : kept_runs(design.foams, half, nx)) count += run.blocks();
            return count;
        };
        const double foam = (blocks(Half::lower) + blocks(Half::lid)) * design.space.block_volume();
        EXPECT_NEAR(cubic_mm(all, "lower") + cubic_mm(all, "lid"),
                    foam - 2 * static_cast<double>(dowels) * bore_volume_mm3(options), foam * 1e-4);
        const auto again = print_pack(design.view(), options);
        for (std::size_t i = 0; i < pack->containers.size(); ++i)
            EXPECT_EQ(again->containers[i].members[2].bytes, pack->containers[i].members[2].bytes);
    }
    EXPECT_GT(packs, static_cast<int>(seeds) * 3 / 10);
}

/// A line of print/parts.csv.
struct ListedPart {
    std::string name;
    std::array<int, 7> numbers{};  ///< first and last level, row, column; blocks
};

std::vector<ListedPart> listed_parts(const WorkshopPack& pack) {
    std::vector<ListedPart> parts;
    for (const PackFile& file : pack.files) {
        if (file.name != "print/parts.csv") continue;
        std::istringstream text(test::text_of(file.bytes));
        std::string line;
        std::getline(text, line);
        while (std::getline(text, line)) {
            std::istringstream cells(line);
            ListedPart part;
            std::getline(cells, part.name, ',');
            char comma = 0;
            for (int& value : part.numbers) cells >> value >> comma;
            parts.push_back(part);
        }
    }
    return parts;
}

/// Asks the part for each block that it may have, and adds the block to the half that it belongs to.
void add_blocks(const test::PrintedItem& item, const ListedPart& part, bool turned, Vec3d s,
                Grid<snug::Run>& levels) {
    const bool lid = item.name.rfind("lid", 0) == 0;
    const auto& n = part.numbers;
    const Box3d box = test::bounds_of(item);
    const double back = (n[3] - n[2] + 1) * s.y;
    for (int row = n[2]; row <= n[3]; ++row)
        for (int column = n[4]; column <= n[5]; ++column)
            for (int level = n[0]; level <= n[1]; ++level) {
                const Vec3d in_part{(level - n[0] + 0.487) * s.x, (row - n[2] + 0.513) * s.y,
                                    (column - n[4] + 0.479) * s.z};
                Vec3d p = seen_from_the_cavity(in_part, lid) + Vec3d{0, lid ? 0 : back, 0};
                if (turned) p = {back - p.y, p.x, p.z};
                const int turns = test::winding(item, p + box.min);
                ASSERT_TRUE(turns == 0 || turns == 1);
                // Levels of a column come in order, so a gap would show as a wrong one.
                if (turns == 0) continue;
                auto& run = levels(row - 1, column - 1);
                if (run.none())
                    run = {static_cast<std::int16_t>(level - 1), static_cast<std::int16_t>(level - 1)};
                ASSERT_EQ(run.end, level - 1);
                ++run.end;
            }
}

TEST(PrintPack, ThePartsPutTogetherAgainAreTheFoam) {
    int parts = 0;
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        test::PrintDesign design = test::random_print_design(random);
        PrintOptions options = test::random_print_options(random);
        options.dowels = false;
        const int nx = design.space.blocks.x;
        if (seed >= 40) design.shorten(test::random_available(random, design.space.blocks));
        const auto pack = print_pack(design.view(), options);
        if (!pack) continue;
        std::map<std::string, test::PrintedItem> items;
        for (const PackContainer& container : pack->containers)
            for (test::PrintedItem& item : test::read_printed(container)) items[item.name] = item;
        Grid<snug::Run> lower(design.space.blocks.y, design.space.blocks.z), upper = lower;
        for (const ListedPart& part : listed_parts(*pack)) {
            const bool lid = part.name.rfind("lid", 0) == 0;
            const Heights heights = test::heights_of(design.foams, lid ? Half::lid : Half::lower, nx);
            const int levels = *std::max_element(heights.begin(), heights.end());
            const bool turned =
                print_cuts({levels, heights.ny(), heights.nz()}, design.space.block_mm, options.bed_mm)
                    .turned;
            add_blocks(items.at(part.name), part, turned, design.space.block_mm, lid ? upper : lower);
            ++parts;
        }
        const auto same = [&](const Grid<snug::Run>& found, Half half) {
            const auto kept = kept_runs(design.foams, half, nx);
            return std::equal(found.begin(), found.end(), kept.begin());
        };
        EXPECT_TRUE(same(lower, Half::lower));
        EXPECT_TRUE(same(upper, Half::lid));
    }
    EXPECT_GT(parts, 200);
}

TEST(PrintPack, TheFitTestIsAFlatClosedRing) {
    const DesignSpace space{{6, 12, 12}, {10, 10, 10}};
    Heights half = test::filled(12, 12, 3);
    for (int j = 4; j < 8; ++j)
        for (int k = 4; k < 7; ++k) half(j, k) = 1;
    const test::PrintDesign design(space, half, half);
    const auto pack = print_pack(design.view(), {});
    ASSERT_TRUE(pack.has_value());
    const PackContainer* test = find(*pack, "print/fit-test-01.3mf");
    ASSERT_NE(test, nullptr);
    const auto items = test::read_printed(*test);
    ASSERT_EQ(items.size(), 1u);
    test::expect_closed(items[0]);
    EXPECT_NEAR(test::bounds_of(items[0]).max.z, 3, 1e-5);
    // Two cells around an opening of 4 x 3.
    EXPECT_NEAR(test::signed_volume(items[0].vertices, items[0].triangles), (8 * 7 - 4 * 3) * 300, 1);
}

TEST(PrintPack, ABedSmallerThanABlockSaysWhichOneWouldDo) {
    const test::PrintDesign design({{2, 2, 2}, {15, 15, 22}}, test::filled(2, 2, 1), test::filled(2, 2, 1));
    PrintOptions options;
    options.bed_mm = {20, 20, 20};
    const auto pack = print_pack(design.view(), options);
    ASSERT_FALSE(pack.has_value());
    EXPECT_EQ(text(pack.error().message),
              "a bed of 20 x 20 x 20 mm is smaller than a block of foam, which lies 22 x 15 x 15 mm on it; "
              "take a bed of at least that, or smaller blocks");
    options.bed_mm.y = std::nan("");
    EXPECT_FALSE(print_pack(design.view(), options).has_value());
}

}  // namespace
}  // namespace snug
