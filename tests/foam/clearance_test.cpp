#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/foam/notches.h"
#include "snug/foam/object_cut.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/space/available.h"

#include "tests/support/broken_foams.h"
#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/fit_designs.h"
#include "tests/support/heights.h"
#include "tests/support/random_design.h"
#include "tests/support/shapes.h"

// Clearances of each half and axis.

namespace snug {
namespace {

using test::Blocks;
using test::box_design;
using test::Broken;
using test::broken_by;
using test::packed;
using test::Random;
using test::random_clearance;
using test::random_soup;
using test::RandomDesign;

TEST(Clearance, EachHalfGivesWayToTheObjectGrownForItAndToNothingElse) {
    long long unlike = 0, crossed = 0;
    for (int seed = 0; seed < test::fit_cases(); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const RandomDesign soup = test::random_design(random);
        const DesignSpace& space = soup.space;
        const Clearance clearance = random_clearance(random, space.block_mm);
        const HalfCuts cuts =
            half_cuts(object_depths(soup.mesh, soup.placement, space, {clearance, soup.cut_on_touch}), space);
        const int level = random.integer(0, space.blocks.x);
        const Foams foams = split(cut_by_both(cuts, level), space, level);
        const test::Heights lower = test::lower_heights(foams),
                            upper = test::upper_heights(foams, space.blocks.x);
        const auto triangles = test::placed_triangles(soup.mesh, soup.placement);
        const Blocks below = test::brute_force_cut(triangles, space, clearance.lower, soup.cut_on_touch);
        const Blocks above = test::brute_force_cut(triangles, space, clearance.upper, soup.cut_on_touch);
        for (int j = 0; j < space.blocks.y; ++j)
            for (int k = 0; k < space.blocks.z; ++k) {
                int first = space.blocks.x, end = 0;
                bool seen_below = false, seen_above = false;
                for (int i = space.blocks.x - 1; i >= 0; --i)
                    if (below.cut(i, j, k)) first = i, seen_below = true;
                for (int i = 0; i < space.blocks.x; ++i)
                    if (above.cut(i, j, k)) end = i + 1, seen_above = true;
                unlike += seen_below != seen_above;
                crossed += seen_below && seen_above && first > end && (level > first || level < end);
                if (!seen_below) first = level;
                if (!seen_above) end = level;
                if (first >= end) {
                    first = std::min(first, level);
                    end = std::max(end, level);
                }
                ASSERT_EQ(lower(j, k), first) << j << " " << k;
                ASSERT_EQ(upper(j, k), space.blocks.x - end) << j << " " << k;
            }
    }
    EXPECT_GT(unlike, test::fit_cases());
    EXPECT_GT(crossed, 0) << "columns whose lower foam ends above where the upper begins";
}

TEST(Clearance, OfEachHalfHoldsInEveryDesignWhateverElseIsCut) {
    const int designs = test::cases(250, 40);
    int unlike = 0, squeezed = 0, in_cases = 0, crossed = 0;
    for (int seed = 0; seed < designs; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 810000);
        Design design;
        design.object.units = Unit::mm;
        design.space.block_mm = {random.between(2, 20), random.between(8, 25), random.between(8, 25)};
        design.space.blocks.reset();
        design.cut.clearance_mm = random_clearance(random, design.space.block_mm);
        if (random.chance(0.5))  // each half sees what the other does not
            design.cut.clearance_mm = {{0, random.between(0, 30), 0}, {0, 0, random.between(0, 30)}};
        design.cut.cut_on_touch = random.chance(0.3);
        for (int axis = 0; axis < 3; ++axis)
            design.placement.rotation_deg[axis] =
                random.chance(0.3) ? 90.0 * random.integer(0, 3) : random.between(-180, 180);
        if (random.chance(0.4)) design.fit.least_rib_mm = random.between(1, 40);
        if (random.chance(0.4))
            design.fit.notches = NotchOptions{
                random.between(10, 80), random.between(5, 40), random.between(5, 30), {}, {}, {}};
        if (random.chance(0.4)) {
            design.case_options.inside_mm = Vec3d{250, 300, 325};
            design.case_options.lid_mm = random.between(40, 150);
            design.case_options.corner_radius_mm = random.between(0, 60);
            design.case_options.base_mm = CrossSection{random.between(230, 300), random.between(250, 325)};
        }
        const Mesh mesh = random_soup(random, {120, 100, 140}, random.integer(2, 25));
        const auto object = prepare(mesh, design);
        ASSERT_TRUE(object);
        auto packing = pack(*object, design);
        if (!packing || !packing->foams) continue;  // smaller blocks than the squeeze allows, or no room
        const auto triangles = test::placed_triangles(object->mesh, packing->items.front().placement);
        const Clearance& clearance = design.cut.clearance_mm;
        const auto cut = [&](Vec3d own) {
            return test::brute_force_cut(triangles, packing->space, own, design.cut.cut_on_touch);
        };
        const Broken broken = broken_by(*packing, cut(clearance.lower), cut(clearance.upper));
        ASSERT_EQ(broken.in_room, 0);
        ASSERT_EQ(broken.in_the_way, 0);
        unlike += !clearance.same_in_both();
        squeezed += clearance.least() < 0;
        crossed += broken.crossed > 0;
        in_cases += !fills_box(packing->available, packing->space.blocks.x);
    }
    EXPECT_GT(unlike, designs / 3);
    EXPECT_GT(squeezed, designs / 6);
    EXPECT_GT(crossed, designs / 20);
    EXPECT_GT(in_cases, designs / 10);
}

TEST(Clearance, OfAPreparedSurfaceIsTheSame) {
    const Mesh mesh = *sample("camera");
    const PreparedSurface surface = prepare_surface(mesh);
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Vec3i blocks{20, random.integer(5, 60), random.integer(5, 60)};
        const Vec3d size = bounds(mesh).size() * 1.5;
        const DesignSpace space{blocks, {size.x / blocks.x, size.y / blocks.y, size.z / blocks.z}};
        const CutOptions cut{random_clearance(random, space.block_mm), random.chance(0.3)};
        const Vec3d rotation{random.between(-180, 180), random.between(-90, 90), random.between(-180, 180)};
        const Placement placement = place(surface, rotation, {});
        const ObjectDepths plain = object_depths(mesh, placement, space, cut);
        const ObjectDepths prepared = object_depths(surface, placement, space, cut);
        const auto same = [](const DepthMap& a, const DepthMap& b) {
            return std::equal(a.begin(), a.end(), b.begin(), [](DepthRange p, DepthRange q) {
                return p.lowest == q.lowest && p.highest == q.highest;
            });
        };
        EXPECT_TRUE(same(plain.lower.depths, prepared.lower.depths));
        ASSERT_EQ(plain.upper.has_value(), prepared.upper.has_value());
        if (plain.upper) {
            EXPECT_TRUE(same(plain.upper->depths, prepared.upper->depths));
        }
    }
}

TEST(Clearance, ALinerIsRoomOnTopOfIt) {
    const Mesh box = test::box_mesh({-20, -30, -30}, {20, 30, 30});
    Design with = box_design(1), without = box_design(3);
    with.cut.liner_mm = 2;
    EXPECT_EQ(packed(box, with).layers, packed(box, without).layers);
    EXPECT_NE(packed(box, with).layers, packed(box, box_design(0)).layers);
}

TEST(Clearance, ALidThatIsLooserAllAroundLeavesTheLowerFoamTight) {
    const Mesh box = test::box_mesh({-20, -30, -30}, {20, 30, 30});
    Design design = box_design();
    design.cut.clearance_mm = {{0, 0, 0}, {0, 15, 15}};
    design.parting.level = 6;
    const Foams foams = *packed(box, design).foams;
    const Foams tight = *packed(box,
                                [&] {
                                    auto same = design;
                                    same.cut.clearance_mm = 0;
                                    return same;
                                }())
                             .foams;
    EXPECT_EQ(foams.piece(Half::lower), tight.piece(Half::lower));
    const test::Heights upper = test::upper_heights(foams, 12);
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k) {
            const bool near = j >= 5 && j < 15 && k >= 5 && k < 15;
            EXPECT_EQ(upper(j, k), near ? 4 : 6) << j << " " << k;
        }
}

}  // namespace
}  // namespace snug
