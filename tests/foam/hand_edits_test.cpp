#include "snug/foam/hand_edits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "snug/design/option_text.h"
#include "snug/make.h"

#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/random_design.h"
#include "tests/support/solid_checks.h"
#include "tests/support/zoned_kit.h"

// What a hand changes, against a brute force that looks at every block.

namespace snug {
namespace {

using test::Random;

struct Edited {
    Object object;
    Design design;
};

/// A soup in a fitted space, of which some columns are changed, also where there are none.
Edited random_edited(Random& random) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {random.between(3, 12), random.between(5, 15), random.between(5, 15)};
    design.space.blocks.reset();
    design.space.wall_mm = equal_walls(random.between(0, 30));
    design.cut.clearance_mm = random.chance(0.3) ? 0 : random.between(0, 12);
    if (random.chance(0.3)) design.cut.liner_mm = random.between(0.1, 2);
    if (random.chance(0.3)) design.fit.least_rib_mm = random.between(1, 30);
    if (random.chance(0.2)) design.space.open = random.between(0.2, 1);
    if (random.chance(0.3)) design.fit.settle = true;
    const Vec3d size{random.between(20, 60), random.between(20, 70), random.between(20, 70)};
    Object object = prepare(test::random_soup(random, size, random.integer(2, 12)), design).value();
    const DesignSpace space = pack(object, design).value().space;
    for (int i = random.integer(1, 60); i > 0; --i) {
        HandEdit edit{random.chance(0.5) ? "lower" : "upper", random.integer(0, space.blocks.y),
                      random.integer(0, space.blocks.z), random.integer(1, 3)};
        if (random.chance(0.6)) edit.blocks = -edit.blocks;
        design.edits.push_back(edit);
    }
    return {std::move(object), std::move(design)};
}

/// Blocks that edits which apply take out of a piece's column.
std::map<std::tuple<std::string, int, int>, int> taken(const Packing& packing, const HandEdits& edits) {
    std::map<std::tuple<std::string, int, int>, int> blocks;
    for (const EditOutcome& outcome : packing.edits) {
        const HandEdit& edit = edits[outcome.edit];
        EXPECT_TRUE(outcome.blocks == (outcome.why_not ? 0 : edit.blocks));
        blocks[{edit.piece, edit.j, edit.k}] += outcome.blocks;
    }
    return blocks;
}

/// The pieces differ from what is computed by what was taken out and put back, and by nothing else.
void expect_changed_so(const Packing& before, const Packing& after, const HandEdits& edits) {
    auto blocks = taken(after, edits);
    for (const Piece piece : after.foams->all())
        for (int j = 0; j < after.space.blocks.y; ++j)
            for (int k = 0; k < after.space.blocks.z; ++k) {
                const Run was = before.foams->piece(piece)(j, k), is = after.foams->piece(piece)(j, k);
                const int less = blocks[{piece.highest() ? "upper" : "lower", j, k}];
                ASSERT_EQ(was.blocks() - is.blocks(), less) << j << " " << k;
                if (is.none() || was.none()) continue;
                ASSERT_EQ(piece.highest() ? was.end : was.first, piece.highest() ? is.end : is.first);
            }
}

/// No piece has a block of the item's, nor of another piece's.
void expect_clear(const Packing& packing, const test::Blocks& item) {
    const Foams& foams = *packing.foams;
    for (int j = 0; j < packing.space.blocks.y; ++j)
        for (int k = 0; k < packing.space.blocks.z; ++k) {
            for (const Piece piece : foams.all())
                for (int block = foams.piece(piece)(j, k).first; block < foams.piece(piece)(j, k).end;
                     ++block)
                    ASSERT_FALSE(item.cut(block, j, k)) << block << " " << j << " " << k;
            if (foams.open() || foams.pieces[0](j, k).none() || foams.pieces[1](j, k).none()) continue;
            ASSERT_LE(foams.pieces[0](j, k).end, foams.pieces[1](j, k).first);
        }
}

/// Where no other edit of its column may have gone farther in.
bool is_alone(const HandEdit& edit, const HandEdits& all) {
    return std::count_if(all.begin(), all.end(),
                         [&](const HandEdit& other) { return other.j == edit.j && other.k == edit.k; }) == 1;
}

TEST(HandEdits, TakeOutAndPutBackWhatTheySayAndNeverEnterTheItem) {
    int applied = 0, refused = 0, put_back = 0, in_clearance = 0;
    const int cases = test::cases(400, 40);
    for (int i = 0; i < cases; ++i) {
        SCOPED_TRACE("seed " + std::to_string(i));
        Random random(static_cast<std::uint32_t>(i) + 7700);
        const Edited edited = random_edited(random);
        const Packing after = pack(edited.object, edited.design).value();
        Design plain = edited.design;
        plain.edits.clear();
        const Packing before = pack(edited.object, plain).value();
        if (!after.foams) continue;
        ASSERT_NO_FATAL_FAILURE(expect_changed_so(before, after, edited.design.edits));
        const test::Blocks item = brute_force_cut(
            test::placed_triangles(edited.object.mesh, after.items.front().placement), after.space, 0, false);
        ASSERT_NO_FATAL_FAILURE(expect_clear(after, item));
        for (const EditOutcome& outcome : after.edits) {
            ++(outcome.why_not ? refused : applied);
            put_back += outcome.blocks < 0;
            if (!outcome.left_mm) continue;
            ++in_clearance;
            ASSERT_GE(*outcome.left_mm, 0);
            ASSERT_LT(*outcome.left_mm, edited.design.cut.clearance_mm.least() + edited.design.cut.liner_mm);
        }
    }
    EXPECT_GT(applied, 5 * cases);
    EXPECT_GT(refused, cases);
    EXPECT_GT(put_back, cases / 4);
    EXPECT_GT(in_clearance, cases / 10);
}

/// Any column of any piece, also of such as there are not.
HandEdits random_edits(Random& random, const DesignSpace& space, int layers) {
    HandEdits edits;
    for (int i = random.integer(1, 80); i > 0; --i) {
        const int piece = random.integer(0, layers);
        HandEdit edit{piece == 0        ? "lower"
                      : piece == layers ? "upper"
                                        : "middle-" + std::to_string(piece),
                      random.integer(0, space.blocks.y), random.integer(0, space.blocks.z),
                      random.integer(1, 3)};
        if (random.chance(0.6)) edit.blocks = -edit.blocks;
        edit.under = piece > 0 && piece < layers && random.chance(0.5);
        edits.push_back(edit);
    }
    return edits;
}

/// Foam that edits put there stands in no item by itself and in none of its zones, and only where blocks are.
void expect_new_foam_is_free(const Packing& before, const Packing& after, std::span<const Object> objects) {
    for (const Item& item : after.items) {
        const test::Blocks bare =
            brute_force_cut(test::placed_triangles(objects[item.object].mesh, item.placement), after.space,
                            Vec3d{0, 0, 0}, item.cut.cut_on_touch);
        std::vector<test::Blocks> barred{bare};
        for (const ItemZone& zone : item.zones)
            if (zone.asked.keep_off_mm > 0)
                barred.push_back(brute_force_cut(test::placed_triangles(zone.surface->mesh, item.placement),
                                                 after.space, zone.asked.keep_off_mm, item.cut.cut_on_touch));
        for (std::size_t piece = 0; piece < after.foams->pieces.size(); ++piece)
            for (int j = 0; j < after.space.blocks.y; ++j)
                for (int k = 0; k < after.space.blocks.z; ++k) {
                    const auto &was = before.foams->pieces[piece](j, k),
                               &is = after.foams->pieces[piece](j, k);
                    for (int block = is.first; block < is.end; ++block) {
                        ASSERT_TRUE(after.available(j, k).contains(block));
                        for (const test::Blocks& blocks : barred)
                            ASSERT_FALSE(!was.contains(block) && blocks.cut(block, j, k))
                                << "piece " << piece << ": " << block << " " << j << " " << k;
                    }
                }
    }
}

void expect_apart(const Foams& foams) {
    for (std::size_t piece = 1; piece < foams.pieces.size(); ++piece)
        for (std::size_t i = 0; i < foams.pieces[piece].size(); ++i) {
            const auto &lower = foams.pieces[piece - 1][i], &upper = foams.pieces[piece][i];
            ASSERT_TRUE(lower.none() || upper.none() || lower.end <= upper.first) << piece << " " << i;
        }
}

TEST(HandEdits, OfKitsWithZonesLayersCasesAndClearancesOfEachSideStayFree) {
    int applied = 0, put_back = 0, in_cases = 0, layered = 0;
    const int kits = test::cases(60, 24);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint32_t>(seed) + 61000);
        test::ZonedKit kit = test::random_kit_with_zones(random);
        if (random.chance(0.4)) {
            kit.design.case_options.inside_mm = Vec3d{260, 420, 425};
            kit.design.case_options.corner_radius_mm = random.between(0, 60);
            kit.design.case_options.base_mm =
                CrossSection{random.between(380, 420), random.between(380, 425)};
        }
        auto design = checked(kit.design);
        ASSERT_TRUE(design) << text(design.error().message);
        const auto before = pack(kit.objects, *design);
        if (!before || !before->foams) continue;
        design->edits = random_edits(random, before->space, before->foams->layers());
        const auto after = pack(kit.objects, *design);
        ASSERT_TRUE(after && after->foams);
        ASSERT_NO_FATAL_FAILURE(expect_new_foam_is_free(*before, *after, kit.objects));
        ASSERT_NO_FATAL_FAILURE(expect_apart(*after->foams));
        in_cases += after->fitted_case.has_value();
        layered += after->foams->layers() > 1;
        for (const EditOutcome& outcome : after->edits) {
            applied += outcome.blocks > 0;
            put_back += outcome.blocks < 0;
        }
    }
    EXPECT_GT(applied, 2 * kits);
    EXPECT_GT(put_back, kits / 4);
    EXPECT_GT(in_cases, kits / 10);
    EXPECT_GT(layered, kits / 10);
}

TEST(HandEdits, WhatIsLeftOfTheClearanceIsLeft) {
    for (int i = 0; i < test::cases(200, 30); ++i) {
        SCOPED_TRACE("seed " + std::to_string(i));
        Random random(static_cast<std::uint32_t>(i) + 9100);
        Edited edited = random_edited(random);
        edited.design.cut.liner_mm = 0;
        edited.design.fit.least_rib_mm = 0;
        const Packing packing = pack(edited.object, edited.design).value();
        if (!packing.foams) continue;
        const auto triangles = test::placed_triangles(edited.object.mesh, packing.items.front().placement);
        for (const EditOutcome& outcome : packing.edits) {
            if (!outcome.left_mm || *outcome.left_mm == 0) continue;
            const HandEdit& edit = edited.design.edits[outcome.edit];
            const auto& kept = packing.foams->pieces[edit.piece == "lower" ? 0 : 1](edit.j, edit.k);
            const test::Blocks grown =
                brute_force_cut(triangles, packing.space, *outcome.left_mm - 0.02, false);
            for (int block = kept.first; is_alone(edit, edited.design.edits) && block < kept.end; ++block)
                ASSERT_FALSE(grown.cut(block, edit.j, edit.k));
        }
    }
}

TEST(HandEdits, AMiddlePieceHasTwoFaces) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {10, 10, 10};
    design.space.blocks.reset();
    design.items.assign(2, ItemOptions());
    design.items[1].layer = 2;
    for (int i = 0; i < 2; ++i) design.items[static_cast<std::size_t>(i)].offset_mm = Vec3d{i * 80.0, 0, 0};
    const Object object = prepare(test::box_mesh({-15, -15, -15}, {15, 15, 15}), design).value();
    const Packing plain = pack(object, design).value();
    design.edits = {
        {"middle-1", 0, 0, 2}, {"middle-1", 1, 0, 1, true}, {"middle-2", 0, 0, 1}, {"upper", 0, 1, 3}};
    const Packing packing = pack(object, design).value();
    const auto &was = plain.foams->pieces[1], &is = packing.foams->pieces[1];
    EXPECT_EQ(is(0, 0).end, was(0, 0).end - 2);
    EXPECT_EQ(is(0, 0).first, was(0, 0).first);
    EXPECT_EQ(is(1, 0).first, was(1, 0).first + 1);
    EXPECT_EQ(is(1, 0).end, was(1, 0).end);
    EXPECT_TRUE(packing.edits[2].why_not);
    EXPECT_EQ(packing.foams->pieces[2](0, 1).first, plain.foams->pieces[2](0, 1).first + 3);
}

TEST(HandEdits, AreTypedAndSaidAgain) {
    const auto edits = typed_edits("lower:12:7:1,upper:0:3:-2,middle-2:4:4:1:under");
    ASSERT_TRUE(edits);
    EXPECT_EQ(edits->at(2), (HandEdit{"middle-2", 4, 4, 1, true}));
    EXPECT_EQ(text_of(*edits), "lower:12:7:1,upper:0:3:-2,middle-2:4:4:1:under");
    for (const char* wrong : {"", "lower", "lower:1:2", "lower:1:2:x", "lower:1:2:3:over", "lower:1:2:3,"})
        EXPECT_FALSE(typed_edits(wrong)) << wrong;
    for (const char* wrong : {"lid:1:2:3", "middle-0:1:2:3", "middle-01:1:2:3", "lower:1:2:0", "lower:-1:2:1",
                              "lower:1:4096:1", "upper:1:2:1:under"})
        EXPECT_TRUE(problem_of(typed_edits(wrong).value())) << wrong;
    Design design;
    design.edits.assign(kMostEdits + 1, HandEdit{"lower", 0, 0, 1});
    EXPECT_FALSE(checked(design));
}

}  // namespace
}  // namespace snug
