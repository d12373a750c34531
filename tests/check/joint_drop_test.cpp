#include "snug/check/joint_drop.h"

#include <cmath>

#include <gtest/gtest.h>

#include "snug/check/gravity.h"

namespace snug {
namespace {

constexpr double kThickness = 100;

StressCurve linear(double kpa_at_one) {
    const std::vector<StressPoint> points{{0.5, kpa_at_one / 2}, {0.95, kpa_at_one * 0.95}};
    return StressCurve(points);
}

/// A spring of so many N/mm on a curve of 100 kPa at the strain 1.
PadContact spring(int low, int high, double newton_per_mm, double gap_mm = 0) {
    return {low, high, Pads({{kThickness, gap_mm, newton_per_mm * kThickness * 10, 0, 0}})};
}

/// The same by itself: two masses, the lower on the floor, the upper on the lower, in very fine steps of
/// Runge and Kutta. Gives the greatest G of each.
std::pair<double, double> integrated(double m0, double m1, double k0, double k1, double gap1,
                                     double height_mm) {
    struct State {
        double x0, x1, v0, v1;
    };
    constexpr double g = kStandardGravity * 1e3;
    const auto pushes = [&](const State& s) {
        return std::make_pair(std::max(0.0, k0 * s.x0), std::max(0.0, k1 * (s.x1 - s.x0 - gap1)));
    };
    const auto slope = [&](const State& s) {
        const auto [f0, f1] = pushes(s);
        return State{s.v0, s.v1, g - (f0 - f1) * 1e3 / m0, g - f1 * 1e3 / m1};
    };
    const auto plus = [](State s, const State& d, double dt) {
        return State{s.x0 + d.x0 * dt, s.x1 + d.x1 * dt, s.v0 + d.v0 * dt, s.v1 + d.v1 * dt};
    };
    const double v = std::sqrt(2 * g * height_mm);
    State s{0, 0, v, v};
    double most0 = 0, most1 = 0;
    bool turned0 = false, turned1 = false;
    for (int i = 0; i < 400000 && !(turned0 && turned1); ++i) {
        constexpr double dt = 5e-7;
        const State a = slope(s), b = slope(plus(s, a, dt / 2)), c = slope(plus(s, b, dt / 2)),
                    d = slope(plus(s, c, dt));
        s = plus(plus(plus(plus(s, a, dt / 6), b, dt / 3), c, dt / 3), d, dt / 6);
        const auto [f0, f1] = pushes(s);
        most0 = std::max(most0, (f0 - f1) / (m0 * kStandardGravity) - 1);
        most1 = std::max(most1, f1 / (m1 * kStandardGravity) - 1);
        turned0 = turned0 || s.v0 <= 0;
        turned1 = turned1 || s.v1 <= 0;
    }
    return {most0, most1};
}

TEST(JointDrop, OfTwoMassesOnTwoSpringsIsTheirMotion) {
    const StressCurve curve = linear(100);
    for (const auto& [m0, m1, k0, k1, gap] :
         {std::array{1.0, 1.0, 10.0, 10.0, 0.0}, std::array{2.0, 0.5, 15.0, 4.0, 3.0},
          std::array{0.5, 2.0, 12.0, 20.0, 6.0}}) {
        const std::vector<PadContact> contacts{spring(PadContact::kCase, 0, k0), spring(0, 1, k1, gap)};
        const JointItems items{{0, 1}, {m0, m1}, {&contacts[0], &contacts[1]}, false};
        const JointStops stops = joint_drop(items, curve, 300, 25);
        ASSERT_TRUE(stops.stops[0] && stops.stops[1]);
        const auto [g0, g1] = integrated(m0, m1, k0, k1, gap, 300);
        EXPECT_NEAR(shock_g(*stops.stops[0], m0) / g0, 1, 0.01);
        EXPECT_NEAR(shock_g(*stops.stops[1], m1) / g1, 1, 0.01);
        EXPECT_FALSE(stops.items_meet);
    }
}

TEST(JointDrop, IsNotWhatSeparateBalancesSay) {
    // Alone each would meet 2 h / s + 1.
    const StressCurve curve = linear(100);
    const std::vector<PadContact> contacts{spring(PadContact::kCase, 0, 10), spring(0, 1, 10)};
    const JointItems items{{0, 1}, {1, 1}, {&contacts[0], &contacts[1]}, false};
    const auto alone = flat_drop({&contacts[0].pads, nullptr, 1e300, 1}, curve, 300, 25);
    const JointStops both = joint_drop(items, curve, 300, 25);
    EXPECT_LT(shock_g(*both.stops[0], 1), 0.85 * shock_g(*alone, 1));
}

TEST(JointDrop, OfOneItemIsTheEnergyBalance) {
    const StressCurve curve = linear(100);
    const std::vector<PadContact> contacts{spring(PadContact::kCase, 0, 8, 4)};
    const JointItems items{{0}, {1.2}, {&contacts[0]}, false};
    const auto alone = flat_drop({&contacts[0].pads, nullptr, 1e300, 1.2}, curve, 500, 25);
    const JointStops stops = joint_drop(items, curve, 500, 25);
    ASSERT_TRUE(alone && stops.stops[0]);
    EXPECT_NEAR(shock_g(*stops.stops[0], 1.2), shock_g(*alone, 1.2), 0.003 * shock_g(*alone, 1.2));
    EXPECT_NEAR(stops.stops[0]->travel_mm, alone->travel_mm, 0.05);
}

TEST(JointDrop, SaysWhereItemsMeet) {
    const StressCurve curve = linear(100);
    const std::vector<PadContact> contacts{spring(PadContact::kCase, 0, 50), spring(0, 1, 1)};
    const JointItems items{{0, 1}, {1, 4}, {&contacts[0], &contacts[1]}, false};
    const JointStops stops = joint_drop(items, curve, 900, 25);
    EXPECT_TRUE(stops.items_meet);
    EXPECT_TRUE(stops.bottoms[0] && stops.bottoms[1]);
    EXPECT_FALSE(stops.stops[0] || stops.stops[1]);
}

TEST(JointDrop, SaysWhereAMotionDoesNotEndInTheStepsThatAreAllowed) {
    // A pad of a millimetre that bears, and one of four metres that takes its time.
    const StressCurve curve = linear(100);
    const std::vector<PadContact> contacts{{PadContact::kCase, 0, Pads({{1, 0, 1e8, 0, 0}})},
                                           {0, 1, Pads({{4000, 0, 1e4, 0, 0}})}};
    const JointItems items{{0, 1}, {1, 1}, {&contacts[0], &contacts[1]}, false};
    const JointStops stops = joint_drop(items, curve, 300, 25);
    EXPECT_TRUE(stops.unsettled);
    EXPECT_FALSE(stops.stops[0] || stops.stops[1] || stops.bottoms[0] || stops.bottoms[1]);
}

TEST(JointRest, EachCarriesAllAboveIt) {
    const StressCurve curve = linear(100);
    const std::vector<PadContact> contacts{spring(PadContact::kCase, 0, 10), spring(0, 1, 5)};
    const JointItems items{{0, 1}, {2, 3}, {&contacts[0], &contacts[1]}, false};
    const JointStops rest = joint_rest(items, curve);
    ASSERT_TRUE(rest.stops[0] && rest.stops[1]);
    EXPECT_NEAR(rest.stops[0]->travel_mm, 5 * kStandardGravity / 10, 0.01);
    EXPECT_NEAR(rest.stops[1]->travel_mm - rest.stops[0]->travel_mm, 3 * kStandardGravity / 5, 0.01);
}

TEST(JointSets, AreThoseThatReachOneAnother) {
    std::vector<PadContact> contacts{spring(0, 2, 1), spring(2, 3, 1), spring(PadContact::kCase, 1, 1)};
    const auto sets = joint_sets(contacts, 5);
    EXPECT_EQ(sets, (std::vector<std::vector<int>>{{0, 2, 3}, {1}, {4}}));
}

}  // namespace
}  // namespace snug
