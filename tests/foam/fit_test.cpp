#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "snug/foam/notches.h"
#include "snug/foam/object_cut.h"
#include "snug/foam/ribs.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/solid/solid.h"
#include "snug/space/available.h"
#include "snug/words/words.h"

#include "tests/support/brute_force.h"
#include "tests/support/random_design.h"
#include "tests/support/shapes.h"
#include "tests/support/solid_checks.h"

// Clearances of each half and axis, ribs, finger notches and bearing areas.

namespace snug {
namespace {

using test::Blocks;
using test::Random;
using test::RandomDesign;

int case_count() {
    const char* text = std::getenv("SNUG_CASES");
    return (text ? std::atoi(text) : 2000) / 4;
}

Clearance random_clearance(Random& random, Vec3d block_mm) {
    const double side = std::min({block_mm.x, block_mm.y, block_mm.z});
    const auto one = [&] { return random.chance(0.3) ? 0 : random.between(-0.4, 1.5) * side; };
    const Vec3d lower{one(), one(), one()};
    return {lower, random.chance(0.2) ? lower : Vec3d{one(), one(), one()}};
}

// ---- clearance

TEST(Clearance, EachHalfGivesWayToTheObjectGrownForItAndToNothingElse) {
    long long unlike = 0, crossed = 0;
    for (int seed = 0; seed < case_count(); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const RandomDesign soup = test::random_design(random);
        const DesignSpace& space = soup.space;
        const Clearance clearance = random_clearance(random, space.block_mm);
        const HalfCuts cuts =
            half_cuts(object_depths(soup.mesh, soup.placement, space, {clearance, soup.cut_on_touch}), space);
        const int level = random.integer(0, space.blocks.x);
        const FoamPair foams = split(cut_by_both(cuts, level), space, level);
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
                ASSERT_EQ(foams.lower(j, k), first) << j << " " << k;
                ASSERT_EQ(foams.upper(j, k), space.blocks.x - end) << j << " " << k;
            }
    }
    EXPECT_GT(unlike, case_count());
    EXPECT_GT(crossed, 0) << "columns whose lower foam ends above where the upper begins";
}

/// Triangles of all sizes within a box of this size.
Mesh random_soup(Random& random, Vec3d size, int triangles) {
    Mesh mesh;
    for (int t = 0; t < triangles; ++t) {
        const double share = random.chance(0.5) ? 0.15 : 1;
        const Vec3d at{random.unit(), random.unit(), random.unit()};
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int corner = 0; corner < 3; ++corner) {
            Vec3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = std::clamp(at[axis] + share * random.between(-1, 1), 0.0, 1.0) * size[axis];
            mesh.vertices.push_back(vec_cast<float>(p));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// What a half keeps where the object, grown for that half, cuts; and where one half lies in the other's way.
struct Broken {
    long long in_room = 0;
    long long in_the_way = 0;
    long long crossed = 0;  ///< columns whose lower foam has to end above where the upper may begin
};

/// Block by block, from a cut of its own for each half.
Broken broken_by(const Packing& packing, const Blocks& below, const Blocks& above) {
    const Vec3i n = packing.space.blocks;
    Broken broken;
    for (int j = 0; j < n.y; ++j)
        for (int k = 0; k < n.z; ++k) {
            bool upper_below = false;
            int lowest = n.x, highest = -1;
            for (int i = 0; i < n.x; ++i) {
                const auto column = packing.blocks.index(j, k);
                const CutRun exists = packing.available[column];
                const bool there = i >= exists.first && i < exists.end;
                const bool lower = there && i < packing.foams->lower[column];
                const bool upper = there && i >= n.x - packing.foams->upper[column];
                broken.in_room += (lower && below.cut(i, j, k)) + (upper && above.cut(i, j, k));
                broken.in_the_way += lower && (upper || upper_below);
                upper_below |= upper;
                if (below.cut(i, j, k)) lowest = std::min(lowest, i);
                if (above.cut(i, j, k)) highest = i;
            }
            broken.crossed += highest >= 0 && lowest < n.x && lowest > highest + 1;
        }
    return broken;
}

TEST(Clearance, OfEachHalfHoldsInEveryDesignWhateverElseIsCut) {
    const int designs = std::max(100, case_count() / 2);
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
        const auto triangles = test::placed_triangles(object->mesh, packing->placement);
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

Design box_design(double clearance = 0) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = Vec3i{12, 20, 20};
    design.space.block_mm = {10, 10, 10};
    design.cut.clearance_mm = clearance;
    return design;
}

Packing packed(const Mesh& mesh, const Design& design) {
    const auto object = prepare(mesh, design);
    EXPECT_TRUE(object);
    auto packing = pack(*object, design);
    EXPECT_TRUE(packing && packing->foams);
    return *packing;
}

TEST(Clearance, ALinerIsRoomOnTopOfIt) {
    const Mesh box = test::box_mesh({-20, -30, -30}, {20, 30, 30});
    Design with = box_design(1), without = box_design(3);
    with.cut.liner_mm = 2;
    EXPECT_EQ(packed(box, with).blocks, packed(box, without).blocks);
    EXPECT_NE(packed(box, with).blocks, packed(box, box_design(0)).blocks);
}

TEST(Clearance, ALidThatIsLooserAllAroundLeavesTheLowerFoamTight) {
    const Mesh box = test::box_mesh({-20, -30, -30}, {20, 30, 30});
    Design design = box_design();
    design.cut.clearance_mm = {{0, 0, 0}, {0, 15, 15}};
    design.parting.level = 6;
    const FoamPair foams = *packed(box, design).foams;
    const FoamPair tight = *packed(box,
                                   [&] {
                                       auto same = design;
                                       same.cut.clearance_mm = 0;
                                       return same;
                                   }())
                                .foams;
    EXPECT_EQ(foams.lower, tight.lower);
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k) {
            const bool near = j >= 5 && j < 15 && k >= 5 && k < 15;
            EXPECT_EQ(foams.upper(j, k), near ? 4 : 6) << j << " " << k;
        }
}

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
    for (int seed = 0; seed < case_count(); ++seed) {
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
        const FoamPair before = split(blocks, space, level);
        const long long cut = cut_thin_ribs(blocks, space, level, least);
        const FoamPair after = split(blocks, space, level);
        const int wy = static_cast<int>(std::ceil(least / space.block_mm.y)),
                  wz = static_cast<int>(std::ceil(least / space.block_mm.z));
        EXPECT_EQ(after.lower, brute_opening(before.lower, wy, wz));
        EXPECT_EQ(after.upper, brute_opening(before.upper, wy, wz));
        long long lost = 0;
        for (std::size_t i = 0; i < blocks.size(); ++i)
            lost += before.lower[i] + before.upper[i] - after.lower[i] - after.upper[i];
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
    for (int j = 0; j < 20; ++j)
        for (int k = 0; k < 20; ++k) {
            const bool in_notch = k >= 8 && k < 12 && ((j >= 6 && j < 8) || (j >= 12 && j < 14));
            const bool in_bar = k >= 6 && k < 14 && j >= 8 && j < 12;
            EXPECT_EQ(packing.foams->lower(j, k), in_bar ? 4 : in_notch ? 5 : 8) << j << " " << k;
            EXPECT_EQ(packing.foams->upper(j, k), 4);
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
        EXPECT_EQ(packing.blocks, packed(bar, plain).blocks);
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

// ---- bearing

TEST(Bearing, OfABoxIsItsFloorOnceItSankThroughTheGap) {
    const Mesh box = test::box_mesh({-18, -30, -20}, {18, 30, 20});  // 2 mm above and below in 10 mm blocks
    const auto object = prepare(box, box_design());
    const auto packing = pack(*object, box_design());
    const auto report = bearing_report(object->mesh, packing->placement, packing->space, *packing->foams);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->lower_mm2[0], 0);
    EXPECT_EQ(report->upper_mm2[0], 0);
    for (const std::size_t sunk : {1, 2}) {
        EXPECT_NEAR(report->lower_mm2[sunk], 60 * 40, 1e-6);
        EXPECT_NEAR(report->upper_mm2[sunk], 60 * 40, 1e-6);
    }
    EXPECT_NEAR(*static_pressure_kpa(2.4, 2400), 9.80665, 1e-9) << "a gram on a square millimetre";
}

TEST(Bearing, OfASphereOnFineFoamIsItsWholeShadowOnceItSankThroughOneBlock) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {1, 1, 1};
    design.space.blocks = Vec3i{120, 120, 120};
    const auto object = prepare(test::sphere_mesh(40, 200), design);
    const auto packing = pack(*object, design);
    const auto report = bearing_report(object->mesh, packing->placement, packing->space, *packing->foams);
    ASSERT_TRUE(report);
    const double shadow = 3.14159265 * 40 * 40;
    EXPECT_LT(report->lower_mm2[0], 0.9 * shadow) << "its flanks are steeper than a millimetre a column";
    EXPECT_GT(report->lower_mm2[2], 0.93 * shadow);
    EXPECT_LE(report->lower_mm2[2], shadow * 1.001);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(report->lower_mm2[i], report->upper_mm2[i], 0.01 * shadow);
    std::vector<Finding> findings;
    find_bearing_problems(*report, 0.5, 17.2, findings);
    EXPECT_TRUE(findings.empty());
    find_bearing_problems(*report, 50, 17.2, findings);
    ASSERT_EQ(findings.size(), 2u) << "50 kg on 50 cm2";
    EXPECT_EQ(findings[0].code(), "creep");
}

// ---- all of it together

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
    const FoamPair& foams = *packing.foams;
    const int nx = packing.space.blocks.x;
    for (std::size_t i = 0; i < packing.blocks.size(); ++i) {
        const CutRun run = packing.blocks[i];
        ASSERT_LE(foams.lower[i] + foams.upper[i], nx);
        if (run.none()) continue;
        ASSERT_LE(foams.lower[i], run.first);
        ASSERT_LE(foams.upper[i], nx - run.end);
    }
    if (!fills_box(packing.available, nx)) return;
    EXPECT_EQ(packing.fit.lower_blocks + packing.fit.upper_blocks + packing.fit.cut_blocks,
              packing.space.block_count());
    test::expect_solid_of(lower_solid(foams, packing.space), foams.lower, packing.space);
    test::expect_solid_of(upper_solid(foams, packing.space), foams.upper, packing.space);
}

TEST(Fit, OfAnyKindComesOutIsClosedAndNeverAddsFoam) {
    int notched = 0, ribbed = 0, tapered = 0;
    const int cases = std::max(20, case_count() / 5);
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
        plain.parting.level = packing->foams->parting_level;
        if (!design.case_options.inside_mm) plain.space.blocks = packing->space.blocks;
        plain.placement.offset_mm = packing->placement.bounds.centre();
        const auto before = pack(*object, plain);
        ASSERT_TRUE(before && before->foams);
        for (std::size_t i = 0; i < packing->blocks.size(); ++i) {
            ASSERT_LE(packing->foams->lower[i], before->foams->lower[i]);
            ASSERT_LE(packing->foams->upper[i], before->foams->upper[i]);
        }
    }
    EXPECT_GT(notched, cases / 10);
    EXPECT_GT(ribbed, cases / 10);
    EXPECT_GT(tapered, cases / 10);
}

}  // namespace
}  // namespace snug
