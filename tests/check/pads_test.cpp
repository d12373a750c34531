#include "snug/check/pads.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "snug/check/flat_drop.h"
#include "snug/check/gravity.h"
#include "snug/design/known_foams.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

/// Stress that is the same at every strain.
StressCurve constant(double kpa) {
    const std::vector<StressPoint> points{{1e-9, kpa}, {0.999, kpa}};
    return StressCurve(points);
}

StressCurve linear(double kpa_at_one) {
    const std::vector<StressPoint> points{{0.5, kpa_at_one / 2}, {0.999, kpa_at_one * 0.999}};
    return StressCurve(points);
}

std::vector<PadColumn> random_columns(test::Random& random, int count) {
    std::vector<PadColumn> columns;
    for (int i = 0; i < count; ++i)
        columns.push_back({10.0 * random.integer(2, 6), random.between(-3, 12), random.between(1, 50),
                           random.between(-40, 40), random.between(-40, 40)});
    return columns;
}

StressCurve random_curve(test::Random& random) {
    std::vector<StressPoint> points;
    double strain = 0, kpa = 0;
    for (int i = random.integer(2, 8); i > 0; --i) {
        strain += random.between(0.02, 0.11);
        kpa += random.between(0.1, 40);
        points.push_back({strain, kpa});
    }
    return StressCurve(points);
}

TEST(Pads, AreTheSumOfTheirColumns) {
    for (int i = 0; i < test::cases(400, 20); ++i) {
        SCOPED_TRACE(i);
        test::Random random(static_cast<std::uint64_t>(1000 + i));
        const auto columns = random_columns(random, random.integer(1, 60));
        const StressCurve curve = random_curve(random);
        const Pads pads(columns);
        const double travel = random.between(-4, 40), thin = 35;
        double newton = 0, along_u = 0, joule = 0, thin_joule = 0, area = 0, strain = 0;
        for (const PadColumn& each : columns) {
            const double own = (travel - each.gap_mm) / each.thickness_mm;
            newton += each.area_mm2 * curve.at(own).kpa * 1e-3;
            along_u += each.area_mm2 * curve.at(own).kpa * 1e-3 * each.u_mm;
            const double last = std::min(own, curve.greatest_strain());
            const double beyond = std::max(0.0, own - last) * curve.at(last).kpa;
            const double taken = each.area_mm2 * each.thickness_mm * (curve.at(last).energy + beyond) * 1e-6;
            joule += taken;
            if (each.thickness_mm < thin) thin_joule += taken;
            if (own > 0) area += each.area_mm2;
            strain = std::max(strain, own);
        }
        EXPECT_NEAR(pads.push(travel, curve).newton, newton, 1e-9 * (1 + newton));
        if (newton > 1e-6) {
            EXPECT_NEAR(pads.push(travel, curve).u_mm, along_u / newton, 1e-6);
        }
        EXPECT_NEAR(pads.taken(travel, curve, thin).joule, joule, 1e-9 * (1 + joule));
        EXPECT_NEAR(pads.taken(travel, curve, thin).thin_joule, thin_joule, 1e-9 * (1 + joule));
        EXPECT_NEAR(pads.area_mm2(travel), area, 1e-9 * (1 + area));
        EXPECT_NEAR(pads.most_squeezed(travel).strain, strain, 1e-12);
    }
}

Pads flat(double area_mm2, double thickness_mm, double gap_mm = 0) {
    return Pads({{thickness_mm, gap_mm, area_mm2, 0, 0}});
}

Cushioned on(const Pads& pads, double kg) {
    return {&pads, nullptr, 1e300, kg};
}

TEST(FlatDrop, OnConstantStressIsTheFallOverTheStop) {
    constexpr double kArea = 1e4, kHeight = 500, kGap = 7, kMass = 2;
    const Pads pads = flat(kArea, 80, kGap);
    const auto stop = flat_drop(on(pads, kMass), constant(60), kHeight, 25);
    ASSERT_TRUE(stop);
    const double squeezed = stop->travel_mm - kGap;
    EXPECT_NEAR(shock_g(*stop, kMass), (kHeight + kGap) / squeezed, 1e-4);
    EXPECT_NEAR(stop->newton, kArea * 60e-3, 1e-6);
}

TEST(FlatDrop, OnALinearSpringIsTwiceTheFallOverTheStopAndOne) {
    constexpr double kHeight = 400, kGap = 5, kMass = 3;
    const Pads pads = flat(2e4, 60, kGap);
    const auto stop = flat_drop(on(pads, kMass), linear(150), kHeight, 25);
    ASSERT_TRUE(stop);
    const double squeezed = stop->travel_mm - kGap;
    EXPECT_NEAR(shock_g(*stop, kMass), 2 * (kHeight + kGap) / squeezed + 1, 1e-6);
}

TEST(FlatDrop, OnAFlatPadIsThatOfTheCurve) {
    const auto foam = find_foam(built_in_foams(), "ethafoam-200lc");
    const StressCurve curve(foam->curve);
    const double kg = 16.3, kpa = 5, area = kg * kStandardGravity / kpa * 1e3;
    const Pads pads = flat(area, 50.8);
    const auto stop = flat_drop(on(pads, kg), curve, 610, 25);
    ASSERT_TRUE(stop);
    const double strain = *curve.strain_of_drop(kpa, 610 / 50.8);
    EXPECT_NEAR(stop->strain, strain, 1e-9);
    EXPECT_NEAR(shock_g(*stop, kg), curve.at(strain).kpa / kpa - 1, 1e-6);
    EXPECT_EQ(stop->thin_share, 0);
    EXPECT_NEAR(flat_drop(on(pads, kg), curve, 610, 60)->thin_share, 1, 1e-12);
}

TEST(FlatDrop, OfTwoPadsWithDifferentGapsIsWhatTheyTakeUpTogether) {
    const StressCurve curve = linear(200);
    const Pads pads({{50, 0, 4000, -30, 0}, {50, 10, 8000, 30, 0}});
    const double kg = 1.5, height = 700;
    const auto stop = flat_drop(on(pads, kg), curve, height, 25);
    ASSERT_TRUE(stop);
    const double d = stop->travel_mm, per_mm = 200.0 / 50;
    const double joule = (4000 * per_mm * d * d / 2 + 8000 * per_mm * (d - 10) * (d - 10) / 2) * 1e-6;
    EXPECT_NEAR(joule, kg * kStandardGravity * (height + d) * 1e-3, 1e-9);
    EXPECT_NEAR(stop->at.x, (-30 * 4000 * d + 30 * 8000 * (d - 10)) / (4000 * d + 8000 * (d - 10)), 1e-6);
}

TEST(FlatDrop, BottomsWhereTheDataEndAndMeetsTheCase) {
    const Pads pads = flat(1000, 30);
    EXPECT_FALSE(flat_drop(on(pads, 20), linear(100), 900, 25));
    const Pads large = flat(1e5, 60);
    Cushioned bare = on(large, 1);
    EXPECT_TRUE(flat_drop(bare, linear(100), 500, 25));
    bare.bare_mm = 2;
    EXPECT_FALSE(flat_drop(bare, linear(100), 500, 25)) << "something of it meets the case before";
    EXPECT_FALSE(flat_drop({}, linear(100), 500, 25)) << "no foam at all";
}

TEST(FlatDrop, IsHelpedByFoamBehindThatWasSqueezed) {
    const Pads ahead = flat(5000, 50, -2), behind = flat(5000, 50, -2);
    const StressCurve curve = linear(100);
    const Cushioned both{&ahead, &behind, 1e300, 2}, one{&ahead, nullptr, 1e300, 2};
    const auto squeezed = flat_drop(both, curve, 300, 25), alone = flat_drop(one, curve, 300, 25);
    ASSERT_TRUE(squeezed && alone);
    // Until it lets go it pushes along with the fall.
    EXPECT_GT(squeezed->travel_mm, alone->travel_mm);
    const double per_mm = 5000 * 100.0 / 50 * 1e-6, d = squeezed->travel_mm;
    EXPECT_NEAR(per_mm * ((d + 2) * (d + 2) - 4) / 2 - per_mm * 4 / 2,
                2 * kStandardGravity * (300 + d) * 1e-3, 1e-9);
}

TEST(FlatDrop, NeverTakesLessTravelForMoreMassOrHeightNorMoreGOnThickerFoam) {
    for (int i = 0; i < test::cases(300, 20); ++i) {
        SCOPED_TRACE(i);
        test::Random random(static_cast<std::uint64_t>(5000 + i));
        const Pads pads(random_columns(random, random.integer(1, 40)));
        const StressCurve curve = random_curve(random);
        const double kg = random.between(0.01, 0.3), height = random.between(20, 400);
        const auto stop = flat_drop(on(pads, kg), curve, height, 25);
        if (!stop) continue;
        const auto heavier = flat_drop(on(pads, kg * 1.2), curve, height, 25);
        const auto higher = flat_drop(on(pads, kg), curve, height * 1.2, 25);
        for (const auto& worse : {heavier, higher}) {
            if (worse) {
                EXPECT_GE(worse->travel_mm, stop->travel_mm - 1e-9);
            }
        }
        const Pads more = pads.thicker(15);
        const auto softer = flat_drop(on(more, kg), curve, height, 25);
        ASSERT_TRUE(softer);
        EXPECT_LE(shock_g(*softer, kg), shock_g(*stop, kg) + 1e-9);
    }
}

TEST(AtRest, CarriesTheWeight) {
    const Pads pads = flat(5000, 50, 3);
    const auto stop = at_rest(on(pads, 4), linear(100));
    ASSERT_TRUE(stop);
    EXPECT_NEAR(stop->newton, 4 * kStandardGravity, 1e-6);
    EXPECT_NEAR(stop->travel_mm, 3 + 4 * kStandardGravity / (5000 * 100.0 / 50 * 1e-3), 1e-6);
}

}  // namespace
}  // namespace snug
