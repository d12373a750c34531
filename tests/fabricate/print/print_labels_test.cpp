#include "snug/fabricate/print/print_labels.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/print/print.h"

#include "tests/support/cases.h"
#include "tests/support/labelled_tray.h"
#include "tests/support/printed_checks.h"

// Labels as letters in printed parts: nothing leaks, nothing is mirrored, and only letters are missing.

namespace snug {
namespace {

using test::PrintedItem;
using test::Random;

std::vector<PrintedItem> printed_parts(const WorkshopPack& pack) {
    std::vector<PrintedItem> parts;
    for (const PackContainer& bed : pack.containers)
        if (bed.name.rfind("print/bed", 0) == 0)
            for (PrintedItem& item : test::read_printed(bed))
                if (item.name != "dowel") parts.push_back(std::move(item));
    return parts;
}

TEST(PrintLabels, LeavePartsClosedWithTheVolumeThatIsTold) {
    std::size_t cut = 0, labels = 0;
    for (int seed = 0; seed < test::cases(40, 10); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 71000);
        const test::LabelledTray tray = test::labelled_tray(random, seed % 3 == 0);
        PrintOptions options;
        options.dowels = random.chance(0.5);
        if (random.chance(0.6))
            options.bed_mm = {random.between(90, 200), random.between(90, 200), random.between(60, 200)};
        const auto pack = print_pack(tray.foams(), options);
        ASSERT_TRUE(pack);
        double volume = 0;
        for (const PrintedItem& part : printed_parts(*pack)) {
            test::expect_closed(part);
            volume += test::signed_volume(part.vertices, part.triangles);
        }
        EXPECT_NEAR(volume * 1e-6 / *pack->material.litres, 1, 1e-5);
        labels += tray.labels.labels.size();
        for (const Finding& finding : pack->findings) cut += finding.code() == "label_cut";
    }
    EXPECT_GT(labels, 3 * cut);
    EXPECT_GT(cut, 0U);
}

TEST(PrintLabels, GoHalfIntoThinFoam) {
    const test::ThinTray tray = test::thin_tray();
    PrintOptions options;
    options.dowels = false;
    const auto pack = print_pack(tray.foams(), options);
    ASSERT_TRUE(pack);
    double volume = 0;
    for (const PrintedItem& part : printed_parts(*pack)) {
        test::expect_closed(part);
        EXPECT_NEAR(test::bounds_of(part).max.z, 0.5, 1e-6);
        volume += test::signed_volume(part.vertices, part.triangles);
    }
    const double whole = (10 * 20 - 25) * 0.5 * 5 * 5;
    EXPECT_NEAR(volume * 1e-6 / *pack->material.litres, 1, 1e-5);
    EXPECT_LT(volume, whole - 1);
    const auto letters = inked(label_lines(tray.labels.front()), 1);
    EXPECT_NEAR(whole - volume, 0.25 * static_cast<double>(area_of(letters)) / 1024 / 1024, 1e-3);
}

/// In the part's coordinates as it lies from the origin, cavity up.
Vec3d on_part(Vec2d at, const Box3d& part, double below_top) {
    return {at.x, part.max.y - at.y, part.max.z - below_top};
}

TEST(PrintLabels, AreReadFromAboveWhereTheyBelong) {
    int strokes = 0;
    for (int seed = 0; seed < test::cases(25, 8); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 72000);
        const test::LabelledTray tray = test::labelled_tray(random);
        PrintOptions options;
        options.bed_mm = {2000, 2000, 2000};
        const auto pack = print_pack(tray.foams(), options);
        ASSERT_TRUE(pack);
        const std::vector<PrintedItem> parts = printed_parts(*pack);
        if (parts.size() != 1) continue;  // islands of foam
        PrintedItem part = parts.front();
        const Vec3d corner = test::bounds_of(part).min;
        for (Vec3f& v : part.vertices) v = v - vec_cast<float>(corner);
        const Box3d box = test::bounds_of(part);
        if (std::abs(box.max.x - tray.packing.space.size().z) > 1e-3) continue;  // turned by a quarter
        for (const ItemLabel& label : tray.labels.labels) {
            const auto lines = label_lines(label);
            for (const auto& line : lines)
                for (std::size_t i = 1; i < line.size(); ++i) {
                    const Vec2d middle = (line[i - 1] + line[i]) * 0.5 + Vec2d{0.0137, 0.0071};
                    EXPECT_EQ(test::winding(part, on_part(middle, box, 0.3)), 0);
                    EXPECT_EQ(test::winding(part, on_part(middle, box, 0.7)), 1);
                    ++strokes;
                }
            Vec2d beside{1e9, label.middle.y + 0.0131};
            for (const auto& line : lines)
                for (const Vec2d p : line) beside.x = std::min(beside.x, p.x - 1.0171);
            EXPECT_EQ(test::winding(part, on_part(beside, box, 0.3)), 1);
        }
    }
    EXPECT_GT(strokes, 100);
}

}  // namespace
}  // namespace snug
