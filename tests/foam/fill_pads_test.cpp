#include "snug/foam/fill_pads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "snug/check/flat_drop.h"
#include "snug/check/protection.h"
#include "snug/design/known_foams.h"
#include "snug/make.h"

#include "tests/support/cases.h"
#include "tests/support/shapes.h"
#include "tests/support/zoned_kit.h"

// Pads that fill what block steps leave.

namespace snug {
namespace {

using test::Random;

bool covers(const FillPad& pad, Vec3d p) {
    return p.y > pad.box.min.y && p.y < pad.box.max.y && p.z > pad.box.min.z && p.z < pad.box.max.z;
}

bool overlap(const FillPad& a, const FillPad& b) {
    return a.piece == b.piece && a.above == b.above && a.first_j < b.end_j && b.first_j < a.end_j &&
           a.first_k < b.end_k && b.first_k < a.end_k;
}

/// Every column under it ends where it begins.
void expect_lies_on_foam(const FillPad& pad, const Packing& packing) {
    const Grid<Run>& foam = packing.foams->piece(pad.piece);
    for (int j = pad.first_j; j < pad.end_j; ++j)
        for (int k = pad.first_k; k < pad.end_k; ++k) {
            ASSERT_FALSE(foam(j, k).none());
            const double face = packing.space.face(0, pad.above ? foam(j, k).first : foam(j, k).end);
            ASSERT_NEAR(face, pad.above ? pad.box.max.x : pad.box.min.x, 1e-9);
        }
}

TEST(FillPads, LieOnFoamAndReachNoItemAndNoZone) {
    int found = 0, above = 0;
    const int kits = test::cases(200, 40);
    for (int seed = 0; seed < kits; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 77000);
        test::ZonedKit kit = test::random_kit_with_zones(random);
        kit.design.fit.pads = PadOptions{random.between(0.5, 4), 0};
        kit.design.space.block_mm.x = random.between(8, 40);
        const auto design = checked(kit.design);
        ASSERT_TRUE(design) << text(design.error().message);
        const auto packing = pack(kit.objects, *design);
        if (!packing || !packing->foams) continue;
        const auto& pads = packing->pads.pads;
        for (std::size_t i = 0; i < pads.size(); ++i) {
            const FillPad& pad = pads[i];
            ++found;
            above += pad.above;
            expect_lies_on_foam(pad, *packing);
            EXPECT_GE(pad.thickness_mm, kLeastPad - 1e-6);
            EXPECT_NEAR(pad.thickness_mm, pad.sheets * kit.design.fit.pads->sheet_mm, 1e-9);
            EXPECT_GE(std::min(pad.box.size().y, pad.box.size().z), kLeastPadSide - 1e-6);
            for (std::size_t other = 0; other < i; ++other) EXPECT_FALSE(overlap(pad, pads[other]));
        }
        for (const Item& item : packing->items)
            for (int n = 0; n < 400; ++n) {
                const Object& object = kit.objects[item.object];
                const Vec3d p = test::point_of(random, object.mesh);
                const Vec3d placed = item.placement(vec_cast<float>(p));
                const bool in_zone = std::any_of(
                    item.zones.begin(), item.zones.end(),
                    [&](const ItemZone& z) { return test::is_in(z.asked, p + object.mesh.origin); });
                for (const FillPad& pad : pads) {
                    if (!covers(pad, placed)) continue;
                    ASSERT_FALSE(in_zone && placed.x > pad.box.min.x - 1e-3 &&
                                 placed.x < pad.box.max.x + 1e-3);
                    const int layer = pad.above ? pad.piece.index : pad.piece.index + 1;
                    if (item.layer != layer) continue;
                    const Clearance clearance = item.cut.whole_clearance_mm();
                    if (clearance.least() < 0) continue;  // its columns do not see all of it
                    if (pad.above)
                        EXPECT_LE(placed.x, pad.box.min.x + 1e-3);
                    else
                        EXPECT_GE(placed.x, pad.box.max.x + clearance.lower.x - 0.011);
                }
            }
    }
    EXPECT_GT(found, kits);
    EXPECT_GT(above, kits / 4);
}

/// A box that floats over a flat floor.
Design floating_box(double rise) {
    Design design;
    design.object.units = Unit::mm;
    design.space.block_mm = {20, 10, 10};
    design.space.blocks = Vec3i{12, 24, 24};
    design.cut.clearance_mm = 1;
    // 60 mm high: its floor at -30 + rise, block faces at multiples of 20.
    design.placement.offset_mm = {rise, 0, 0};
    design.fit.pads = PadOptions{2, 0};
    return design;
}

TEST(FillPads, FillWhatAFlatBoxLeaves) {
    Design design = floating_box(5);  // from -25 to 35: foam ends at -40 and 40
    const Object object = prepare(test::box_mesh({0, 0, 0}, {60, 100, 80}), design).value();
    const auto packing = pack(object, *checked(design));
    ASSERT_TRUE(packing && packing->foams);
    ASSERT_EQ(packing->pads.pads.size(), 2U);
    const FillPad &below = packing->pads.pads[0], &above = packing->pads.pads[1];
    EXPECT_FALSE(below.above);
    EXPECT_NEAR(below.thickness_mm, 14, 1e-9);  // of 15 less the clearance
    EXPECT_NEAR(below.box.min.x, -40, 1e-9);
    EXPECT_TRUE(above.above);
    EXPECT_NEAR(above.thickness_mm, 4, 1e-9);  // of 5
    EXPECT_NEAR(above.box.max.x, 40, 1e-9);
    for (const FillPad& pad : packing->pads.pads) {
        EXPECT_GE(pad.box.size().y, 100);
        EXPECT_GE(pad.box.size().z, 80);
    }
    design.fit.pads->squeeze_mm = 3;
    const auto squeezed = pack(object, *checked(design));
    EXPECT_NEAR(squeezed->pads.pads[1].thickness_mm, 8, 1e-9);  // of 5 and 3 more
}

TEST(FillPads, CountInADropAsFoamThatStandsThere) {
    Design design = floating_box(5);
    design.fit.pads = PadOptions{2, 3};
    design.workshop.mass_kg = 1.5;
    design.protection.foam = *find_foam(built_in_foams(), "ld33");
    design.protection.height_mm = 500;
    const Object object = prepare(test::box_mesh({0, 0, 0}, {60, 100, 80}), design).value();
    auto packing = pack(object, *checked(design));
    ASSERT_TRUE(packing && packing->foams);
    const auto held = protection(std::span(&object, 1), *packing, *checked(design));
    ASSERT_TRUE(held);
    const FaceShock& floor = held->items.front().faces[kFloor];
    ASSERT_TRUE(floor.g_model);
    // 80 mm of foam and a pad of 14 below, 15 to fall; above 80 and a pad of 8 in a gap of 5.
    const double area = 100 * 80;
    const Pads ahead({{94, 1, area, 0, 0}}), behind({{88, -3, area, 0, 0}});
    const Cushioned box{&ahead, &behind, std::numeric_limits<double>::infinity(), 1.5};
    const auto stop = flat_drop(box, StressCurve(design.protection.foam->curve), 500, 25);
    ASSERT_TRUE(stop);
    EXPECT_NEAR(*floor.g_model, shock_g(*stop, 1.5), 0.01 * *floor.g_model);
    EXPECT_NEAR(*held->items.front().pressed_n,
                behind.push(0, StressCurve(design.protection.foam->curve)).newton,
                0.01 * *held->items.front().pressed_n);
}

}  // namespace
}  // namespace snug
