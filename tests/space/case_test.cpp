#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "snug/check/find_case_problems.h"
#include "snug/design/presets.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/solid/solid.h"
#include "snug/space/case_space.h"
#include "snug/words/words.h"

#include "tests/support/closedness.h"
#include "tests/support/heights.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;

CaseOptions hard_case() {
    CaseOptions options;
    options.inside_mm = Vec3d{155, 284, 425};
    options.lid_mm = 45;
    return options;
}

CaseOptions random_case(Random& random) {
    CaseOptions options;
    options.inside_mm = Vec3d{random.between(60, 300), random.between(90, 400), random.between(90, 600)};
    options.play_mm = random.chance(0.2) ? 0 : random.between(0, 8);
    if (random.chance(0.7)) options.lid_mm = random.between(0, 0.9 * options.inside_mm->x);
    return options;
}

void shape(CaseOptions& options, Random& random) {
    const Vec3d inside = *options.inside_mm;
    const auto narrower = [&] {
        return CrossSection{inside.y * random.between(0.8, 1), inside.z * random.between(0.8, 1)};
    };
    if (random.chance(0.6)) options.base_mm = narrower();
    if (options.lid_mm.value_or(0) > 0 && random.chance(0.6)) options.top_mm = narrower();
    if (random.chance(0.7))
        options.corner_radius_mm = random.between(0, 0.4 * std::min(inside.y, inside.z) - 2);
}

double volume(Vec3d size) {
    return size.x * size.y * size.z;
}

double filler_volume(const CaseSpace& fitted, int level) {
    double sum = 0;
    for (const Filler& filler : fillers(fitted, level)) sum += volume(filler.size_mm);
    return sum;
}

Result<Packing> packed(const Mesh& mesh, const Design& design) {
    const auto object = prepare(mesh, *checked(design));
    return pack(*object, design);
}

TEST(Case, BlocksFillersAndPlayAddUpToTheInsideForEveryPreset) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        for (const Preset& preset : built_in_presets()) {
            CaseOptions options = random_case(random);
            options.division = preset.division;
            const auto fitted = case_space(options, preset.block_mm);
            ASSERT_TRUE(fitted) << text(fitted.error().message);
            const DesignSpace& space = fitted->space;
            for (int axis = 0; axis < 3; ++axis) {
                const double sum =
                    space.blocks[axis] * space.block_mm[axis] + fitted->rest_mm[axis] + 2 * options.play_mm;
                EXPECT_NEAR(sum, (*options.inside_mm)[axis], 0.0101);
                EXPECT_LT(fitted->rest_mm[axis], preset.block_mm[axis]);
                const bool free =
                    preset.division == Division::all || (preset.division == Division::across && axis > 0);
                if (free) {
                    EXPECT_EQ(fitted->rest_mm[axis], 0);
                } else {
                    EXPECT_EQ(space.block_mm[axis], preset.block_mm[axis]);
                }
            }
            const int level = random.integer(0, space.blocks.x);
            const double whole = volume(fitted->free.size());
            EXPECT_NEAR(volume(space.size()) + filler_volume(*fitted, level), whole, whole * 1e-3);
        }
    }
}

TEST(Case, FoamsPartAtTheBlockBoundaryNearestToTheLidsLine) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        CaseOptions options = random_case(random);
        options.lid_mm = random.between(0, 0.9 * options.inside_mm->x);
        const auto fitted = case_space(options, {15, 15, 22});
        ASSERT_TRUE(fitted);
        ASSERT_TRUE(fitted->lid_level);
        const double line = options.inside_mm->x - *options.lid_mm;
        const double begin = options.play_mm + (fitted->rest_under ? fitted->rest_mm.x : 0);
        EXPECT_NEAR(begin + *fitted->lid_level * 15, line + fitted->lid_off_mm, 1e-9);
        for (const double other : {options.play_mm, options.play_mm + fitted->rest_mm.x})
            for (int level = 0; level <= fitted->space.blocks.x; ++level)
                EXPECT_GE(std::fabs(other + level * 15 - line) + 1e-5, std::fabs(fitted->lid_off_mm));
    }
}

TEST(Case, ACameraInAHardCaseKeepsItsWallsAndPartsAtTheLid) {
    Design design;
    design.case_options = hard_case();
    apply(*find_preset(built_in_presets(), "slit-10"), design);
    design.space.wall_mm = equal_walls(20);
    const auto packing = packed(scaled(*sample("camera"), 0.8), design);
    ASSERT_TRUE(packing) << text(packing.error().message);
    ASSERT_TRUE(packing->foams);
    const CaseSpace& fitted = *packing->fitted_case;
    EXPECT_EQ(fitted.space.blocks, (Vec3i{7, 27, 41}));
    EXPECT_NEAR(fitted.rest_mm.x, 9, 1e-9);
    EXPECT_NEAR(fitted.rest_mm.y, 8, 1e-9);
    EXPECT_NEAR(fitted.rest_mm.z, 9, 1e-9);
    // The lid's line is 110 mm up: 3 + 9 + 5 x 20 = 112 with the rest below, 3 + 5 x 20 = 103 without.
    EXPECT_EQ(packing->foams->parting.front(), 5);
    EXPECT_TRUE(fitted.rest_under);
    EXPECT_NEAR(fitted.lid_off_mm, 2, 1e-9);
    const auto list = fillers(fitted, 5);
    ASSERT_EQ(list.size(), 5u);
    EXPECT_EQ(list[0].side, kFloor);
    EXPECT_EQ(volume(list[0].size_mm), 9.0 * 278 * 419);
    for (std::size_t i = 1; i < list.size(); ++i) EXPECT_EQ(list[i].size_mm.x, list[i].lid ? 40 : 100);
    EXPECT_NEAR(volume(fitted.space.size()) + filler_volume(fitted, 5), 149.0 * 278 * 419, 1e-3);
    for (const double wall : packing->fit.wall_mm) EXPECT_GE(wall, 20);
}

TEST(Case, ShortenedColumnsHoldEveryBlockInsideTheCaseAndNoPointOutside) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        CaseOptions options = random_case(random);
        shape(options, random);
        if (problem_of(options)) continue;
        const auto fitted = case_space(options, {15, 15, 22});
        ASSERT_TRUE(fitted);
        const auto available = available_blocks(*fitted);
        const DesignSpace& space = fitted->space;
        const Vec3d inside = *options.inside_mm;
        // Independent of the code: a point by its height, in a rectangle whose corners are cut off.
        const auto point_inside = [&](Vec3d p) {
            const double height = p.x - fitted->free.min.x + options.play_mm;
            const double line = inside.x - options.lid_mm.value_or(0);
            double width = inside.y, length = inside.z;
            if (height < line && options.base_mm) {
                width += (options.base_mm->width - inside.y) * (line - height) / line;
                length += (options.base_mm->length - inside.z) * (line - height) / line;
            } else if (height > line && options.top_mm) {
                width += (options.top_mm->width - inside.y) * (height - line) / (inside.x - line);
                length += (options.top_mm->length - inside.z) * (height - line) / (inside.x - line);
            }
            const double y = std::fabs(p.y - fitted->free.centre().y) + options.play_mm;
            const double z = std::fabs(p.z - fitted->free.centre().z) + options.play_mm;
            if (y > width / 2 + 1e-5 || z > length / 2 + 1e-5) return false;
            const double r = std::max(options.corner_radius_mm, options.play_mm);
            const double dy = y - (width / 2 - r), dz = z - (length / 2 - r);
            const double most = r - options.play_mm + 1e-5;
            const double in_y = dy - options.play_mm, in_z = dz - options.play_mm;
            if (in_y <= 0 || in_z <= 0) return true;
            return in_y * in_y + in_z * in_z <= most * most || r <= options.play_mm;
        };
        for (int j = 0; j < space.blocks.y; ++j) {
            for (int k = 0; k < space.blocks.z; ++k) {
                const CutRun run = available(j, k);
                for (int i = 0; i < space.blocks.x; ++i) {
                    const Vec3d low{space.face(0, i), space.face(1, j), space.face(2, k)};
                    bool corners = true, points = true;
                    for (int corner = 0; corner < 8; ++corner)
                        corners &= point_inside({low.x + (corner & 1 ? 15 : 0), low.y + (corner & 2 ? 15 : 0),
                                                 low.z + (corner & 4 ? 22 : 0)});
                    const bool kept = i >= run.first && i < run.end;
                    EXPECT_EQ(kept, corners) << i << " " << j << " " << k;
                    for (int sample = 0; kept && sample < 4; ++sample)
                        points &= point_inside(
                            low + Vec3d{random.between(0, 15), random.between(0, 15), random.between(0, 22)});
                    EXPECT_TRUE(points);
                }
            }
        }
    }
}

/// depths.csv read line by line: it counts what the report counts, and every block that it names lies inside
/// the case.
void expect_depths_tell_the_foams(const Packing& packing) {
    const DesignSpace& space = packing.space;
    std::istringstream text(depths_csv(*packing.foams, packing.available, space.blocks.x));
    std::string header;
    std::getline(text, header);
    const bool shortened = packing.fit.shortened_blocks > 0;
    ASSERT_EQ(header,
              std::string("j,k,lower_blocks,upper_blocks") + (shortened ? ",lower_first,upper_first" : ""));
    long long lower = 0, upper = 0, columns = 0;
    int j = 0, k = 0, below = 0, above = 0;
    char comma = 0;
    while (text >> j >> comma >> k >> comma >> below >> comma >> above) {
        int first = 0, upper_first = space.blocks.x - above;
        if (shortened) text >> comma >> first >> comma >> upper_first;
        for (int i = 0; i < space.blocks.x; ++i) {
            const bool kept =
                (i >= first && i < first + below) || (i >= upper_first && i < upper_first + above);
            if (!kept) continue;
            ASSERT_TRUE(lies_inside(*packing.fitted_case,
                                    {space.face(0, i), space.face(1, j), space.face(2, k)},
                                    {space.face(0, i + 1), space.face(1, j + 1), space.face(2, k + 1)}));
        }
        ASSERT_LE(first + below, upper_first);
        ASSERT_LE(upper_first + above, space.blocks.x);
        lower += below;
        upper += above;
        ++columns;
    }
    EXPECT_EQ(columns, 1LL * space.blocks.y * space.blocks.z);
    EXPECT_EQ(lower, packing.fit.lower().blocks);
    EXPECT_EQ(upper, packing.fit.upper().blocks);
}

TEST(Case, RandomObjectsInShapedCasesKeepEveryInvariant) {
    int shortened = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Design design;
        design.case_options = random_case(random);
        shape(design.case_options, random);
        if (problem_of(design.case_options)) continue;
        design.placement.rotation_deg = {random.between(0, 360), random.between(0, 360),
                                         random.between(0, 360)};
        const auto packing = packed(scaled(*sample("camera"), random.between(0.2, 0.5)), design);
        ASSERT_TRUE(packing) << text(packing.error().message);
        if (!packing->foams) continue;
        const FitReport& fit = packing->fit;
        EXPECT_EQ(fit.lower().blocks + fit.upper().blocks + fit.cut_blocks + fit.shortened_blocks,
                  packing->space.block_count());
        shortened += fit.shortened_blocks > 0;
        bool told = false;
        for (const Finding& finding : packing->findings) told |= finding.code() == "leaves_case";
        EXPECT_EQ(told, fit.outside_blocks > 0);
        for (const bool lower : {true, false}) {
            const Solid solid = lower ? lower_solid(*packing->foams, packing->space)
                                      : upper_solid(*packing->foams, packing->space);
            const long long blocks = lower ? fit.lower().blocks : fit.upper().blocks;
            EXPECT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
            EXPECT_TRUE(test::closed_when_welded(solid.vertices, solid.triangles));
            const double wanted = static_cast<double>(blocks) * packing->space.block_volume();
            EXPECT_NEAR(test::signed_volume(solid.vertices, solid.triangles), wanted, wanted * 1e-5 + 1e-3);
        }
        expect_depths_tell_the_foams(*packing);
        // It comes out: above what is kept of the lower half in a column there is none of it.
        const int nx = packing->space.blocks.x;
        const test::Heights lower = test::lower_heights(*packing->foams),
                            upper = test::upper_heights(*packing->foams, nx);
        for (std::size_t c = 0; c < packing->layers.front().size(); ++c) {
            const CutRun cut = packing->layers.front()[c];
            if (cut.none()) continue;
            EXPECT_LE(lower[c], cut.first);
            EXPECT_LE(upper[c], nx - cut.end);
        }
    }
    EXPECT_GT(shortened, 10);
}

TEST(Case, AnObjectThatDoesNotFitIsToldWhatWould) {
    Design design;
    design.case_options = hard_case();
    const auto packing = packed(test::box_mesh({0, 0, 0}, {200, 100, 100}), design);
    ASSERT_TRUE(packing);
    EXPECT_FALSE(packing->foams);
    const std::string message = text(packing->findings.front().message);
    EXPECT_NE(message.find("65 mm of height"), std::string::npos) << message;
    EXPECT_NE(message.find("A case would do from"), std::string::npos) << message;
}

TEST(Case, WhatTheSentenceAsksForIsEnoughAndTheLeast) {
    const Mesh box = test::box_mesh({0, 0, 0}, {97, 61, 133});
    Design design;
    const Walls walls{30, 20, 50, 40, 10, 25};
    design.case_options.inside_mm =
        least_inside(design.case_options, design.space.block_mm, {97, 61, 133}, 0, walls);
    EXPECT_TRUE(packed(box, design)->foams);
    design.space.blocks.reset();
    design.case_options.inside_mm.reset();
    design.space.wall_mm = walls;
    const auto fitted = packed(box, design);
    for (std::size_t side = 0; side < 6; ++side) {
        EXPECT_GE(fitted->fit.wall_mm[side], walls[side]);
        EXPECT_LT(fitted->fit.wall_mm[side], walls[side] + 22);
    }
}

}  // namespace
}  // namespace snug
