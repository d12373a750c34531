#include "snug/check/protection.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "snug/check/gravity.h"
#include "snug/design/known_foams.h"
#include "snug/make.h"

#include "tests/support/fit_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

FoamMaterial ld33() {
    return *find_foam(built_in_foams(), "ld33");
}

/// 12 x 20 x 20 blocks of 10 mm, half a metre above the floor.
Design dropped_design(double kg, double height_mm = 500) {
    Design design = test::box_design();
    design.protection.foam = ld33();
    design.protection.height_mm = height_mm;
    design.workshop.mass_kg = kg;
    return design;
}

/// Of one object.
struct Dropped {
    Packing packing;
    Protection protection;
    [[nodiscard]] const FaceShock& face(Side side) const {
        return protection.items.front().faces[static_cast<std::size_t>(side)];
    }
};

Dropped dropped(const Mesh& mesh, const Design& design) {
    const auto object = prepare(mesh, design);
    EXPECT_TRUE(object);
    auto packing = pack(*object, design);
    EXPECT_TRUE(packing);
    Dropped all{std::move(*packing), {}};
    auto found = protection(std::span(&*object, 1), all.packing, design);
    EXPECT_TRUE(found);
    all.protection = std::move(*found);
    return all;
}

/// What a flat block of this area meets on a pad.
double g_on_pad(double kg, double area_mm2, double thickness_mm, double height_mm) {
    const StressCurve curve(ld33().curve);
    const double kpa = kg * kStandardGravity / area_mm2 * 1e3;
    const auto strain = curve.strain_of_drop(kpa, height_mm / thickness_mm);
    EXPECT_TRUE(strain);
    return curve.at(*strain).kpa / kpa - 1;
}

TEST(Protection, OfABoxIsThatOfAFlatPadOnEachFace) {
    // 40 x 80 x 60 between walls of 40, 60 and 70 mm, and flush with blocks on every side.
    const Mesh box = test::box_mesh({-20, -40, -30}, {20, 40, 30});
    const Dropped all = dropped(box, dropped_design(0.8));
    const double areas[3] = {80 * 60, 40 * 60, 40 * 80}, walls[3] = {40, 60, 70};
    for (int side = 0; side < 6; ++side) {
        SCOPED_TRACE(side);
        const FaceShock& face = all.face(static_cast<Side>(side));
        ASSERT_TRUE(face.g_model);
        EXPECT_NEAR(*face.g_model / g_on_pad(0.8, areas[side / 2], walls[side / 2], 500), 1, 1e-3);
        EXPECT_NEAR(face.area_cm2, areas[side / 2] / 100, 0.01);
        EXPECT_NEAR(face.tilt_mm, 0, 0.05);
        ASSERT_TRUE(face.g_low && face.g_high);
        EXPECT_LE(*face.g_low, 0.8 * *face.g_model + 1e-9);
        EXPECT_GE(*face.g_high, 1.2 * *face.g_model - 1e-9);
        EXPECT_FALSE(face.bottoms);
    }
}

TEST(Protection, FallsThroughTheGapAndSaysWhereTheRangeEnds) {
    // 4 mm of gap below and above, 6 on the other sides.
    const Mesh box = test::box_mesh({-16, -34, -24}, {16, 34, 24});
    const Dropped all = dropped(box, dropped_design(0.8));
    const FaceShock& floor = all.face(kFloor);
    ASSERT_TRUE(floor.travel_mm && floor.g_model);
    const StressCurve curve(ld33().curve);
    const double area = 68 * 48, squeezed = *floor.travel_mm - 4;
    EXPECT_NEAR(curve.at(squeezed / 40).energy * area * 40 * 1e-6,
                0.8 * kStandardGravity * (500 + *floor.travel_mm) * 1e-3, 5e-3);
    EXPECT_NEAR(floor.strain, squeezed / 40, 1e-9);
}

TEST(Protection, OfACylinderOnItsSideIsThatOfItsChords) {
    // Its axis along y, 30 mm in radius and 120 long; a numerical integral over its breadth, apart from the
    // code: gap of the chord at z, foam behind it to the wall in whole blocks of 1 mm.
    constexpr double kRadius = 30, kLength = 120, kHalf = 60, kMass = 0.9, kHeight = 400;
    Mesh cylinder = test::ringed_mesh(4, 720, false, [](int ring, int step) {
        const double angle = 2 * 3.14159265358979323846 * step / 720;
        const double r = ring == 0 || ring == 3 ? 0 : kRadius, y = ring < 2 ? -kLength / 2 : kLength / 2;
        return Vec3d{r * std::cos(angle), y, r * std::sin(angle)};
    });
    Design design = dropped_design(kMass, kHeight);
    design.space.block_mm = {1, 1, 1};
    design.space.blocks = Vec3i{120, 220, 160};
    const Dropped all = dropped(cylinder, design);
    const StressCurve curve(ld33().curve);
    const auto sum = [&](double travel, bool energy) {
        double all_of_it = 0;
        constexpr int kSteps = 60000;
        for (int i = 0; i < kSteps; ++i) {
            const double z = kRadius * ((i + 0.5) * 2 / kSteps - 1);
            const double low = -std::sqrt(kRadius * kRadius - z * z);
            // Over the column that holds z the cylinder's lowest point decides what is cut.
            const double inner = std::floor(std::fabs(z));
            const double cut = -std::sqrt(kRadius * kRadius - inner * inner);
            const double foam_end = std::floor(cut + 0.01 - 0.01 + 1e-9);
            const double gap = low - foam_end, thickness = kHalf + foam_end;
            const auto value = curve.at((travel - gap) / thickness);
            all_of_it += (energy ? value.energy * thickness : value.kpa) * kLength * 2 * kRadius / kSteps;
        }
        return all_of_it;
    };
    const FaceShock& floor = all.face(kFloor);
    ASSERT_TRUE(floor.travel_mm && floor.g_model);
    const double taken = sum(*floor.travel_mm, true) * 1e-6;
    EXPECT_NEAR(taken / (kMass * kStandardGravity * (kHeight + *floor.travel_mm) * 1e-3), 1, 0.02);
    EXPECT_NEAR(sum(*floor.travel_mm, false) * 1e-3 / (kMass * kStandardGravity) - 1, *floor.g_model,
                0.02 * *floor.g_model);
}

TEST(Protection, AddsWhatTheFarEndMeetsWhereTheCentreOfMassLiesBeside) {
    const Mesh box = test::box_mesh({-20, -40, -30}, {20, 40, 30});
    Design design = dropped_design(0.8);
    design.protection.centre_mm = Vec3d{0, 10, 0};
    const Dropped all = dropped(box, design);
    const FaceShock& floor = all.face(kFloor);
    ASSERT_TRUE(floor.g_model && floor.g_high);
    EXPECT_NEAR(floor.tilt_mm, 10, 0.05);
    // The foam pushes 10 mm beside the mass, whose far end on that side is 50 mm away.
    const double r2 = (80.0 * 80 + 40 * 40) / 12;
    EXPECT_NEAR(*floor.g_low / (0.8 * *floor.g_model * (1 + 10 * 50 / r2)), 1, 0.25);
    EXPECT_GE(*floor.g_high, 1.2 * *floor.g_model * (1 + 10 * 50 / r2) * 0.995);
}

TEST(Protection, SaysWhatWouldDoAndThatIsTrue) {
    const Mesh box = test::box_mesh({-20, -40, -30}, {20, 40, 30});
    Design design = dropped_design(0.8, 600);
    const Dropped first = dropped(box, design);
    design.protection.fragility_g = *first.face(kFloor).g_high * 0.8;
    const Dropped judged = dropped(box, design);
    const FaceShock& floor = judged.face(kFloor);
    ASSERT_TRUE(floor.more_foam_mm);
    EXPECT_TRUE(std::any_of(judged.packing.findings.begin(), judged.packing.findings.end(),
                            [](const Finding& finding) { return finding.code() == "shock"; }));
    // So many blocks more below and above.
    const int more = static_cast<int>(std::ceil(*floor.more_foam_mm / 10));
    design.space.blocks->x += 2 * more;
    EXPECT_LE(*dropped(box, design).face(kFloor).g_high, *design.protection.fragility_g);
    design.space.blocks->x -= 2 * more;
    if (*floor.more_foam_mm > 10) {
        design.space.blocks->x += 2 * (more - 1);
        EXPECT_GT(*dropped(box, design).face(kFloor).g_high, *design.protection.fragility_g * 0.97);
    }
}

TEST(Protection, TellsWhyThereIsNone) {
    const Mesh box = test::box_mesh({-20, -40, -30}, {20, 40, 30});
    Design design = dropped_design(0.8);
    design.workshop.mass_kg.reset();
    EXPECT_EQ(dropped(box, design).face(kBack).why_none, NoShock::no_mass);
    design = dropped_design(0.8);
    design.protection.foam = find_foam(built_in_foams(), "ethafoam-220").value();
    EXPECT_EQ(dropped(box, design).face(kBack).why_none, NoShock::no_foam_data);
    design = dropped_design(0.8, 100);
    design.space.blocks->x = 8;  // 20 mm below and above
    EXPECT_EQ(dropped(box, design).face(kFloor).why_none, NoShock::thin);
    EXPECT_FALSE(dropped(box, design).face(kFloor).g_model);
    design = dropped_design(40);
    EXPECT_TRUE(dropped(box, design).face(kFloor).bottoms);
    EXPECT_EQ(dropped(box, design).packing.findings.front().severity, Severity::danger);
}

}  // namespace
}  // namespace snug
