#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/search/search_design.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

/// The camera askew in a real hard case with leaning walls and round corners.
Design random_case_design(Random& random) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {20, 10, 10};
    design.space.wall_mm = equal_walls(10);
    design.case_options.inside_mm = Vec3d{155, 284, 425};
    design.case_options.lid_mm = 45;
    design.case_options.corner_radius_mm = random.between(0, 80);
    design.case_options.base_mm = CrossSection{random.between(200, 284), random.between(300, 425)};
    design.placement.rotation_deg = {random.between(-180, 180), random.between(-12, 12),
                                     random.between(-12, 12)};
    return design;
}

TEST(SearchInACase, NeverCutsMoreKeepsTheWallsAndStaysAmongTheBlocksThatExist) {
    int searched = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Design design = random_case_design(random);
        auto object = prepare(*sample("camera"), design);
        ASSERT_TRUE(object);
        prepare_for_many(*object);
        const auto before = pack(*object, design);
        ASSERT_TRUE(before);
        SearchTask task;
        task.placement = true;
        task.evaluations = test::cases_at_most(700);
        const auto report = search_design(*object, design, task);
        ASSERT_TRUE(report) << text(report.error().message);
        const auto after = pack(*object, design);
        ASSERT_TRUE(after);
        ASSERT_TRUE(after->foams);
        EXPECT_EQ(after->space.blocks, before->space.blocks);
        EXPECT_EQ(after->fit.outside_blocks, 0);
        EXPECT_EQ(after->fit.cut_blocks, report->cut_blocks);
        if (!before->foams || before->fit.outside_blocks > 0) continue;
        ++searched;
        EXPECT_EQ(before->fit.cut_blocks, report->start_cut_blocks);
        EXPECT_LE(after->fit.cut_blocks, before->fit.cut_blocks);
        for (std::size_t side = 0; side < 6; ++side)
            EXPECT_GE(after->fit.wall_mm[side], std::min(10.0, before->fit.wall_mm[side]));
    }
    EXPECT_GT(searched, 2);
}

TEST(SearchInACase, FitsNoCaseWhereOneIsGiven) {
    Random random(1);
    Design design = random_case_design(random);
    auto object = prepare(*sample("camera"), design);
    prepare_for_many(*object);
    SearchTask task;
    task.fit_case = true;
    const auto report = search_design(*object, design, task);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace snug
