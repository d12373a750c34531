#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "snug/foam/notches.h"
#include "snug/foam/ribs.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/solid/solid.h"
#include "snug/space/available.h"
#include "snug/words/words.h"

#include "tests/support/fit_designs.h"
#include "tests/support/heights.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_checks.h"

// Ribs, finger notches, and every kind of cut together.

namespace snug {
namespace {

using test::box_design;
using test::packed;
using test::Random;
using test::random_clearance;

// ---- ribs

/// The opening from its definition: each column as high as the best rectangle that holds it.
Grid<std::uint16_t> brute_opening(const Grid<std::uint16_t>& heights, int wy, int wz) {
    Grid<std::uint16_t> result(heights.ny(), heights.nz());
    for (int j0 = 1 - wy; j0 < heights.ny(); ++j0)
        for (int k0 = 1 - wz; k0 < heights.nz(); ++k0) {
            std::uint16_t least = 65535;
            for (int j = std::max(j0, 0); j < std::min(j0 + wy, heights.ny()); ++j)
                for (int k = std::max(k0, 0); k < std::min(k0 + wz, heights.nz()); ++k)
                    least = std::min(least, heights(j, k));
            for (int j = std::max(j0, 0); j < std::min(j0 + wy, heights.ny()); ++j)
                for (int k = std::max(k0, 0); k < std::min(k0 + wz, heights.nz()); ++k)
                    result(j, k) = std::max(result(j, k), least);
        }
    return result;
}

TEST(Ribs, AreWhatNoRectangleOfTheLeastSizeFitsUnder) {
    for (int seed = 0; seed < test::fit_cases(); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const DesignSpace space{{random.integer(1, 9), random.integer(1, 14), random.integer(1, 14)},
                                {5, random.between(2, 9), random.between(2, 9)}};
        const int level = random.integer(0, space.blocks.x);
        BlockMap blocks(space.blocks.y, space.blocks.z);
        for (CutRun& run : blocks)
            if (random.chance(0.6)) {
                const int first = random.integer(0, space.blocks.x - 1);
                run = {static_cast<std::int16_t>(first),
                       static_cast<std::int16_t>(random.integer(first + 1, space.blocks.x))};
            }
        const double least = random.between(0.1, 40);
        const Foams before = split(blocks, space, level);
        const long long cut = cut_thin_ribs(blocks, space, level, least);
        const Foams after = split(blocks, space, level);
        const int wy = static_cast<int>(std::ceil(least / space.block_mm.y)),
                  wz = static_cast<int>(std::ceil(least / space.block_mm.z));
        long long lost = 0;
        for (const Half half : {Half::lower, Half::lid}) {
            const test::Heights high = test::heights_of(before, half, space.blocks.x),
                                low = test::heights_of(after, half, space.blocks.x);
            EXPECT_EQ(low, brute_opening(high, wy, wz));
            for (std::size_t i = 0; i < blocks.size(); ++i) lost += high[i] - low[i];
        }
        EXPECT_EQ(cut, lost);
    }
}

TEST(Ribs, BetweenTwoCavitiesAreCutAndWhatIsWideStays) {
    Mesh pair = test::box_mesh({-20, -40, -30}, {20, -10, 30});
    test::append(pair, test::box_mesh({-20, 10, -30}, {20, 40, 30}));  // a rib of 20 mm between
    Design design = box_design();
    design.parting.level = 8;
    EXPECT_EQ(packed(pair, design).rib_blocks, 0);
    design.fit.least_rib_mm = 20;
    EXPECT_EQ(packed(pair, design).rib_blocks, 0);
    design.fit.least_rib_mm = 20.5;
    const Packing cut = packed(pair, design);
    EXPECT_EQ(cut.rib_blocks, 4 * 6 * 2) << "4 blocks high, 6 long, 2 wide";
    EXPECT_EQ(cut.fit.wall_mm, packed(pair, box_design()).fit.wall_mm);
}

// ---- notches

Design notched_design() {
    Design design = box_design();
    design.parting.level = 8;
    design.fit.notches = NotchOptions{40, 30, 20, {}, {}, {}};
    return design;
}

TEST(Notches, LieOppositeAcrossTheNarrowWayInTheMiddle) {
    // 40 mm across y, 80 along z: columns 8-11, 6-13.
    const Mesh bar = test::box_mesh({-20, -20, -40}, {20, 20, 40});
    const Packing packing = packed(bar, notched_design());
    ASSERT_EQ(packing.notches.size(), 2u);
    EXPECT_EQ(packing.notches[0].side, kBack);
    EXPECT_EQ(packing.notches[1].side, kFront);
    for (const Notch& notch : packing.notches) {
        EXPECT_EQ(notch.at_mm, 0);
        EXPECT_EQ(notch.size_mm, (Vec3d{30, 20, 40}));
    }
    const test::Heights lower = test::lower_heights(*packing.foams),
                        upper = test::upper_heights(*packing.foams, 12);
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k) {
            const bool in_notch = k >= 8 && k < 12 && ((j >= 6 && j < 8) || (j >= 12 && j < 14));
            const bool in_bar = k >= 6 && k < 14 && j >= 8 && j < 12;
            EXPECT_EQ(lower(j, k), in_bar ? 4 : in_notch ? 5 : 8) << j << " " << k;
            EXPECT_EQ(upper(j, k), 4);
        }
}

TEST(Notches, GoWhereTheyAreMoved) {
    const Mesh bar = test::box_mesh({-20, -20, -40}, {20, 20, 40});
    Design design = notched_design();
    design.fit.notches->first_mm = -20;
    design.fit.notches->second_mm = 10;
    const Packing packing = packed(bar, design);
    ASSERT_EQ(packing.notches.size(), 2u);
    EXPECT_EQ(packing.notches[0].at_mm, -20);
    EXPECT_EQ(packing.notches[1].at_mm, 10);
    design.fit.notches = NotchOptions{40, 30, 20, NotchAxis::z, {}, {}};
    EXPECT_EQ(packed(bar, design).notches.at(0).side, kLeft);
}

TEST(Notches, WithoutRoomAreASentenceAndTheFoamStaysWhole) {
    const Mesh bar = test::box_mesh({-20, -20, -40}, {20, 20, 40});
    Design plain = notched_design();
    plain.fit.notches.reset();
    for (const NotchOptions& options :
         {NotchOptions{40, 30, 80, {}, {}, {}}, NotchOptions{40, 80, 20, {}, {}, {}},
          NotchOptions{400, 30, 20, {}, {}, {}}, NotchOptions{40, 30, 20, NotchAxis::y, 95, {}}}) {
        Design design = notched_design();
        design.fit.notches = options;
        const Packing packing = packed(bar, design);
        EXPECT_TRUE(packing.notches.empty());
        EXPECT_EQ(packing.layers.front(), packed(bar, plain).layers.front());
        EXPECT_TRUE(std::any_of(packing.findings.begin(), packing.findings.end(), [](const Finding& finding) {
            return finding.code() == "no_notches" && text(finding.message).find("mm") != std::string::npos;
        }));
    }
}

TEST(Notches, FitASpaceThatIsFittedToThem) {
    for (const char* name : {"camera", "torus", "vase", "figurine"}) {
        SCOPED_TRACE(name);
        Design design;
        design.object.units = Unit::mm;
        design.space.block_mm = {10, 10, 10};
        design.space.blocks.reset();
        design.placement.rotation_deg = {0, 90, 0};
        design.fit.notches = NotchOptions{50, 20, 25, {}, {}, {}};
        const Packing packing = packed(*sample(name), design);
        EXPECT_EQ(packing.notches.size(), 2u);
        for (const double wall : packing.fit.wall_mm) EXPECT_GE(wall, 50);
    }
}

Design random_fit(Random& random) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(6, 20), random.between(5, 12), random.between(5, 12)};
    design.space.wall_mm = Walls{random.between(0, 30), random.between(0, 30), random.between(0, 30),
                                 random.between(0, 30), random.between(0, 30), random.between(0, 30)};
    design.space.blocks.reset();
    design.cut.clearance_mm = random_clearance(random, design.space.block_mm);
    design.cut.cut_on_touch = random.chance(0.3);
    for (int axis = 0; axis < 3; ++axis) design.placement.rotation_deg[axis] = random.between(-180, 180);
    if (random.chance(0.7)) design.fit.least_rib_mm = random.between(1, 40);
    if (random.chance(0.7))
        design.fit.notches =
            NotchOptions{random.between(10, 80), random.between(5, 40), random.between(5, 30), {}, {}, {}};
    if (random.chance(0.4)) {  // a case that leans and is round
        design.case_options.inside_mm = Vec3d{300, 400, 425};
        design.case_options.lid_mm = random.between(60, 150);
        design.case_options.corner_radius_mm = random.between(0, 60);
        design.case_options.base_mm = CrossSection{random.between(330, 400), random.between(350, 425)};
    }
    return design;
}

void expect_comes_out_and_is_whole(const Packing& packing) {
    const Foams& foams = *packing.foams;
    const int nx = packing.space.blocks.x;
    const test::Heights lower = test::lower_heights(foams), upper = test::upper_heights(foams, nx);
    for (std::size_t i = 0; i < packing.layers.front().size(); ++i) {
        const CutRun run = packing.layers.front()[i];
        ASSERT_LE(lower[i] + upper[i], nx);
        if (run.none()) continue;
        ASSERT_LE(lower[i], run.first);
        ASSERT_LE(upper[i], nx - run.end);
    }
    for (const Half half : {Half::lower, Half::lid}) test::expect_solid_of(foams, half, packing.space);
    if (!fills_box(packing.available, nx)) return;
    EXPECT_EQ(packing.fit.lower().blocks + packing.fit.upper().blocks + packing.fit.cut_blocks,
              packing.space.block_count());
}

TEST(Fit, OfAnyKindComesOutIsClosedAndNeverAddsFoam) {
    int notched = 0, ribbed = 0, tapered = 0;
    const int cases = std::max(20, test::fit_cases() / 5);
    for (int seed = 0; seed < cases; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 70000);
        const Design design = random_fit(random);
        const auto object = prepare(*sample(random.chance(0.5) ? "camera" : "vase"), design);
        const auto packing = pack(*object, design);
        ASSERT_TRUE(packing) << text(packing.error().message);
        if (!packing->foams) continue;
        expect_comes_out_and_is_whole(*packing);
        notched += !packing->notches.empty();
        ribbed += packing->rib_blocks > 0;
        tapered += !fills_box(packing->available, packing->space.blocks.x);
        Design plain = design;
        plain.fit = {};
        plain.parting.level = packing->foams->parting.front();
        if (!design.case_options.inside_mm) plain.space.blocks = packing->space.blocks;
        plain.placement.offset_mm = packing->items.front().placement.bounds.centre();
        const auto before = pack(*object, plain);
        ASSERT_TRUE(before && before->foams);
        for (const Half half : {Half::lower, Half::lid}) {
            const int nx = packing->space.blocks.x;
            const test::Heights cut = test::heights_of(*packing->foams, half, nx),
                                whole = test::heights_of(*before->foams, half, nx);
            for (std::size_t i = 0; i < cut.size(); ++i) ASSERT_LE(cut[i], whole[i]);
        }
    }
    EXPECT_GT(notched, cases / 10);
    EXPECT_GT(ribbed, cases / 10);
    EXPECT_GT(tapered, cases / 10);
}

}  // namespace
}  // namespace snug
