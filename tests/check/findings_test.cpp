#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/space/fitted_space.h"
#include "snug/words/words.h"

#include "tests/support/random.h"

namespace snug {
namespace {

/// A closed box, or one without its sides in the list (0: -x, 1: +x, 2: -y, 3: +y, 4: -z, 5: +z).
Mesh box(Vec3f low, Vec3f high, std::initializer_list<int> missing = {}) {
    static constexpr int kSides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back(
            {corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    for (int side = 0; side < 6; ++side) {
        if (std::find(missing.begin(), missing.end(), side) != missing.end()) continue;
        const auto& s = kSides[side];
        mesh.triangles.push_back({static_cast<std::uint32_t>(s[0]), static_cast<std::uint32_t>(s[1]),
                                  static_cast<std::uint32_t>(s[2])});
        mesh.triangles.push_back({static_cast<std::uint32_t>(s[0]), static_cast<std::uint32_t>(s[2]),
                                  static_cast<std::uint32_t>(s[3])});
    }
    return mesh;
}

Mesh joined(Mesh a, const Mesh& b) {
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + first, j + first, k + first});
    return a;
}

Design design_of(Vec3i blocks, double size) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = blocks;
    design.space.block_mm = {size, size, size};
    return design;
}

Packing packed(const Mesh& mesh, const Design& design) {
    const auto object = prepare(mesh, design);
    EXPECT_TRUE(object.has_value());
    const auto packing = pack(*object, design);
    EXPECT_TRUE(packing.has_value());
    return *packing;
}

std::vector<std::string> codes(const Packing& packing) {
    std::vector<std::string> found;
    for (const Finding& finding : packing.findings) found.emplace_back(finding.code());
    return found;
}

using Codes = std::vector<std::string>;

TEST(Findings, AClosedBoxInItsMiddleHasNone) {
    EXPECT_EQ(codes(packed(box({0, 0, 0}, {60, 60, 60}), design_of({10, 10, 10}, 15))), Codes{});
}

TEST(Findings, AMissingBaseIsADangerUntilItIsCapped) {
    const Mesh open_below = box({0, 0, 0}, {58, 58, 58}, {0});
    Design design = design_of({10, 10, 10}, 15);
    const Packing open = packed(open_below, design);
    // 2 x 2 columns inside see only the top: three of their four blocks would be foam.
    ASSERT_EQ(codes(open), Codes{"open"});
    EXPECT_EQ(open.findings[0].severity, Severity::danger);
    EXPECT_NE(text(open.findings[0].message).find("12 blocks"), std::string::npos)
        << text(open.findings[0].message);

    design.object.cap = true;
    const Packing capped = packed(open_below, design);
    EXPECT_EQ(codes(capped), Codes{"capped"});
    EXPECT_EQ(capped.layers, packed(box({0, 0, 0}, {58, 58, 58}), design).layers);
}

TEST(Findings, AnOpenObjectWhoseFacesLieOnBlockFacesIsADangerToo) {
    // Only the top is seen, and a sheet between two blocks cuts neither.
    const Packing open = packed(box({0, 0, 0}, {60, 60, 60}, {0}), design_of({10, 10, 10}, 15));
    EXPECT_EQ(codes(open), (Codes{"open", "uncut_part"}));
}

TEST(Findings, CapsAreNoPartsAndBelongToThePartThatTheyClose) {
    // What is left without its base lies on the faces of blocks and cuts nothing by itself.
    Design design = design_of({10, 10, 10}, 15);
    design.object.cap = true;
    for (const int side : {0, 1, 2, 3, 4, 5}) {
        const Packing capped = packed(box({0, 0, 0}, {60, 60, 60}, {side}), design);
        EXPECT_EQ(codes(capped), Codes{"capped"}) << side;
        EXPECT_EQ(capped.layers, packed(box({0, 0, 0}, {60, 60, 60}), design_of({10, 10, 10}, 15)).layers);
    }
    // A part that no cap belongs to is still one that foam would press on.
    const Mesh two = joined(box({0, 0, 0}, {58, 58, 58}, {0}), box({29.5f, 70, 0}, {30.5f, 100, 30}));
    design.space.blocks = Vec3i{12, 16, 12};
    design.cut.clearance_mm = -2;
    EXPECT_EQ(codes(packed(two, design)).front(), "uncut_part");
}

TEST(Findings, WhatWasAskedForAndDidNothingIsSaid) {
    const Mesh closed = box({10, 0, 0}, {70, 60, 60});
    Design design = design_of({10, 10, 10}, 15);
    design.object.cap = true;
    EXPECT_EQ(codes(packed(closed, design)), Codes{"nothing_to_cap"});
    design.object.cap = false;
    design.object.point_radius_mm = 3;
    EXPECT_EQ(codes(packed(closed, design)), Codes{"no_points"});
    design.object.point_radius_mm = 0;
    design.object.clean.drop_below_mm = 5;
    const Packing kept = packed(closed, design);
    ASSERT_EQ(codes(kept), Codes{"nothing_dropped"});
    EXPECT_NE(text(kept.findings[0].message).find("the smallest is 60 mm"), std::string::npos)
        << text(kept.findings[0].message);
}

TEST(Findings, APlaneThatMeetsNothingSaysWhereTheObjectLies) {
    Mesh closed = box({10, 0, 0}, {70, 60, 60});
    closed.origin = {1000, 0, 0};
    Design design = design_of({10, 10, 10}, 15);
    design.object.clean.cut_plane = {{2, 0, 0, 900}};
    const Packing missed = packed(closed, design);
    ASSERT_EQ(codes(missed), Codes{"cut_missed"});
    EXPECT_EQ(missed.findings[0].severity, Severity::warning);
    EXPECT_NE(text(missed.findings[0].message).find("from 1010 to 1070 mm"), std::string::npos)
        << text(missed.findings[0].message);
    design.object.clean.cut_plane = {{2, 0, 0, 1040}};
    EXPECT_EQ(codes(packed(closed, design)), Codes{"cut_off"});
}

/// The numbers that a finding gives behind an option; none where it does not name it.
std::optional<Vec3d> advised(const Packing& packing, const std::string& option, char separator) {
    for (const Finding& finding : packing.findings) {
        const std::string message = text(finding.message);
        const std::size_t at = message.find(option + " ");
        if (at == std::string::npos) continue;
        Vec3d numbers;
        const char* next = message.c_str() + at + option.size() + 1;
        for (int axis = 0; axis < 3; ++axis) {
            char* end = nullptr;
            numbers[axis] = std::strtod(next, &end);
            if (axis < 2 && *end != separator) return {};
            next = end + 1;
        }
        return numbers;
    }
    return {};
}

bool has_thin_wall(const Packing& packing) {
    const auto found = codes(packing);
    return std::any_of(found.begin(), found.end(), [](const std::string& code) {
        return code.rfind("thin_", 0) == 0 || code == "wall_below_wanted" || code == "touches_case" ||
               code == "no_floor" || code == "no_roof";
    });
}

TEST(Findings, WhatAThinWallAdvisesIsDoneAndThenTheWallsAreThere) {
    int moves = 0, counts = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Design design = design_of({random.integer(5, 14), random.integer(5, 14), random.integer(5, 14)}, 15);
        design.space.block_mm.z = random.between(8, 22);
        for (int axis = 0; axis < 3; ++axis)
            design.placement.offset_mm[axis] = random.chance(0.5) ? 0 : random.between(-40, 40);
        if (random.chance(0.5)) design.space.wall_mm = equal_walls(random.between(10, 60));
        const Mesh mesh = box({0, 0, 0}, {static_cast<float>(random.between(20, 70)), 40, 35});
        const Packing thin = packed(mesh, design);
        if (!thin.foams || !has_thin_wall(thin)) continue;
        if (const auto shift = advised(thin, "--move", ',')) {
            design.placement.offset_mm = *shift;
            ++moves;
        } else if (const auto blocks = advised(thin, "--blocks", 'x')) {
            design.space.blocks = vec_cast<int>(*blocks);
            ++counts;
        } else {
            ADD_FAILURE() << text(thin.findings.front().message);
        }
        const Packing mended = packed(mesh, design);
        EXPECT_FALSE(has_thin_wall(mended)) << text(mended.findings.front().message);
    }
    EXPECT_GT(moves, 5);
    EXPECT_GT(counts, 5);
}

TEST(Findings, AFittedSpaceIsAdvisedOtherWallsAndACaseNoBlocks) {
    const Mesh mesh = box({0, 0, 0}, {60, 60, 60});
    Design fitted = design_of({1, 1, 1}, 15);
    fitted.space.blocks.reset();
    fitted.space.wall_mm = Walls{10, 50, 50, 50, 50, 50};
    const Packing thin = packed(mesh, fitted);
    ASSERT_EQ(codes(thin), Codes{"thin_floor"});
    EXPECT_NE(text(thin.findings[0].message).find("--wall 25,50,50,50,50,50 would do"), std::string::npos)
        << text(thin.findings[0].message);
    fitted.space.wall_mm = Walls{25, 50, 50, 50, 50, 50};
    EXPECT_EQ(codes(packed(mesh, fitted)), Codes{});

    Design cased = design_of({1, 1, 1}, 15);
    cased.space.blocks.reset();
    cased.case_options.inside_mm = Vec3d{96, 216, 216};
    const Packing low = packed(mesh, cased);
    ASSERT_TRUE(has_thin_wall(low));
    EXPECT_EQ(text(low.findings[0].message).find("blocks"), std::string::npos)
        << text(low.findings[0].message);
    EXPECT_NE(text(low.findings[0].message).find("take a case of 216 x 216 x 186 mm inside"),
              std::string::npos)
        << text(low.findings[0].message);
    cased.case_options.inside_mm = Vec3d{186, 216, 216};
    EXPECT_FALSE(has_thin_wall(packed(mesh, cased)));
}

TEST(Findings, WhatDoesNotCushionIsNotTooThinToCushion) {
    Design design = design_of({1, 1, 1}, 2);
    design.space.preset = "print";
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(6);
    EXPECT_EQ(codes(packed(box({0, 0, 0}, {60, 60, 60}), design)), Codes{});
    design.space.preset = "slit-15";
    EXPECT_TRUE(has_thin_wall(packed(box({0, 0, 0}, {60, 60, 60}), design)));
}

TEST(Findings, AnOpeningAtTheSideLetsNoFoamIn) {
    EXPECT_EQ(codes(packed(box({0, 0, 0}, {60, 60, 60}, {3}), design_of({10, 10, 10}, 15))), Codes{});
}

TEST(Findings, AnOpenTubeAlongTheInsertionAxisIsADanger) {
    const Packing tube = packed(box({0, 0, 0}, {58, 58, 58}, {0, 1}), design_of({10, 10, 10}, 15));
    ASSERT_EQ(codes(tube), Codes{"open"});
    EXPECT_NE(text(tube.findings[0].message).find("16 blocks"), std::string::npos)
        << text(tube.findings[0].message);
}

TEST(Findings, WallsAreNamedWhereTheyAreThinOrGone) {
    const Mesh part = box({0, 0, 0}, {60, 60, 60});
    EXPECT_EQ(codes(packed(part, design_of({6, 10, 10}, 15))), (Codes{"thin_floor", "thin_roof"}));
    EXPECT_EQ(codes(packed(part, design_of({10, 4, 10}, 15))), (Codes{"touches_case", "touches_case"}));
    Design wanted = design_of({10, 10, 10}, 15);
    wanted.space.wall_mm = equal_walls(50);
    EXPECT_EQ(codes(packed(part, wanted)).size(), 6u);
    EXPECT_EQ(codes(packed(part, wanted)).front(), "wall_below_wanted");
}

TEST(Findings, NoFoamUnderOrOverTheObjectIsADanger) {
    const Packing filled = packed(box({0, 0, 0}, {60, 60, 60}), design_of({4, 10, 10}, 15));
    EXPECT_EQ(codes(filled), (Codes{"no_floor", "no_roof"}));
    EXPECT_EQ(filled.fit.wall_mm[kFloor], 0);
}

TEST(Findings, NobodyIsToldToTakeMoreBlocksWhereACaseDecidesThem) {
    const Mesh part = box({0, 0, 0}, {90, 120, 130});
    for (const double side : {100.0, 130.0, 160.0})
        for (const double level : {0.0, 60.0}) {
            Design design = design_of({1, 1, 1}, 15);
            design.space.blocks.reset();
            design.case_options.inside_mm = Vec3d{side, side + 40, side + 60};
            if (level > 0) design.case_options.lid_mm = level;
            const Packing made = packed(part, design);
            EXPECT_FALSE(made.findings.empty());
            for (const Finding& finding : made.findings)
                EXPECT_EQ(text(finding.message).find("more blocks"), std::string::npos)
                    << text(finding.message);
        }
}

TEST(Findings, AFoamInTwoPiecesIsNamed) {
    // A plate through the whole space parts the foam in two; it also touches the case.
    const auto found = codes(packed(box({0, 0, 0}, {150, 30, 150}), design_of({10, 10, 10}, 15)));
    EXPECT_NE(std::find(found.begin(), found.end(), "lower_pieces"), found.end());
    EXPECT_NE(std::find(found.begin(), found.end(), "upper_pieces"), found.end());
}

TEST(Findings, AnObjectThatLeavesTheSpaceGetsNoFoams) {
    const Packing outside = packed(box({0, 0, 0}, {60, 60, 60}), design_of({3, 10, 10}, 15));
    EXPECT_FALSE(outside.foams.has_value());
    EXPECT_EQ(codes(outside), Codes{"outside"});
    EXPECT_TRUE(packed(box({0, 0, 0}, {60, 60, 60}), design_of({4, 4, 4}, 15)).foams.has_value());
    Design moved = design_of({4, 4, 4}, 15);
    moved.placement.offset_mm = {0, 0, 0.1};
    EXPECT_FALSE(packed(box({0, 0, 0}, {60, 60, 60}), moved).foams.has_value());
}

TEST(Findings, APartThatCutsNothingIsADanger) {
    // A thin plate exactly between two layers of blocks, squeezed.
    const Mesh mesh = joined(box({0, 0, 0}, {60, 60, 60}), box({29.5f, 70, 0}, {30.5f, 100, 30}));
    Design design = design_of({12, 16, 12}, 15);
    design.cut.clearance_mm = -2;
    const auto found = codes(packed(mesh, design));
    EXPECT_EQ(found.front(), "uncut_part");
    design.cut.clearance_mm = 0;
    EXPECT_NE(codes(packed(mesh, design)).front(), "uncut_part");
}

TEST(Findings, SeparatePartsAreNotedAndSpecksWarnedOf) {
    const Mesh two = joined(box({0, 0, 0}, {60, 60, 60}), box({0, 0, 70}, {60, 60, 90}));
    EXPECT_EQ(codes(packed(two, design_of({10, 10, 12}, 15))), Codes{"parts"});
    const Mesh speck = joined(box({0, 0, 0}, {60, 60, 60}), box({80, 0, 0}, {81, 1, 1}));
    EXPECT_EQ(codes(packed(speck, design_of({12, 10, 10}, 15))), Codes{"specks"});
}

TEST(FittedSpace, CountsTheObjectAndItsWalls) {
    const Vec3d block{15, 15, 22};
    const Box3d object{{-30, -30, -33}, {30, 30, 33}};
    EXPECT_EQ(fitted_blocks(object, block), (Vec3d{4, 4, 3}));
    EXPECT_EQ(fitted_blocks(object, block, equal_walls(50)), (Vec3d{4 + 8, 4 + 8, 3 + 6}));
    EXPECT_EQ(fitted_blocks(grown(object, 0.5), block), (Vec3d{5, 5, 4}));
    EXPECT_EQ(fitted_blocks({{0, 0, 0}, {0, 0, 0}}, block, equal_walls(15)), (Vec3d{3, 3, 3}));
}

TEST(FittedSpace, KeepsTheWantedWallsInAnyPlacement) {
    const Mesh vase = *sample("vase");
    for (int turn = 0; turn < 30; ++turn) {
        SCOPED_TRACE(turn);
        Design design = design_of({1, 1, 1}, 7);
        design.space.blocks.reset();
        design.space.wall_mm = equal_walls(5.0 * (turn % 8));
        design.cut.clearance_mm = 0.7 * (turn % 5);
        design.placement.rotation_deg = {37.0 * turn, 59.0 * turn, 83.0 * turn};
        const Packing packing = packed(vase, design);
        ASSERT_TRUE(packing.foams.has_value());
        for (const double wall : packing.fit.wall_mm) EXPECT_GE(wall, design.space.wall_mm->front());
    }
}

TEST(Prepare, AsksForTheUnitOnlyWhenTheSizeIsImplausible) {
    Design design;
    const auto message = [&](float size) {
        const auto object = prepare(box({0, 0, 0}, {size, size, size}), design);
        return object ? std::string() : text(object.error().message);
    };
    EXPECT_EQ(message(60), "");
    EXPECT_NE(message(0.2f).find("as m it measures 200 x 200 x 200 mm"), std::string::npos) << message(0.2f);
    EXPECT_NE(message(6000).find("longer than 5 m"), std::string::npos);
    EXPECT_NE(message(0).find("no size"), std::string::npos);
    design.object.units = Unit::in;
    EXPECT_EQ(message(0.2f), "");
    design.object = {};
    design.object.longest_mm = 100;
    const auto scaled_box = prepare(box({0, 0, 0}, {1, 2, 4}), design);
    EXPECT_EQ(scaled_box->measure.bounds.size(), (Vec3d{25, 50, 100}));
}

}  // namespace
}  // namespace snug
