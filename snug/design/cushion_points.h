#pragma once

#include <span>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/stress_curve.h"

namespace snug {

/// One point of a cushion curve, as makers publish them (ASTM D1596: a flat weight falls on a flat pad).
struct CushionPoint {
    double static_kpa = 0;  ///< weight over area
    double g = 0;           ///< greatest deceleration, in units of gravity
    double thickness_mm = 0;
    double height_mm = 0;  ///< of the drop
};

/// A curve that gives such points back.
struct CushionFit {
    std::vector<StressPoint> curve;        ///< up to the greatest strain that one of the points reached
    std::vector<double> residuals;         ///< of each point, (computed - published) / published G
    double least_mm = 0, greatest_mm = 0;  ///< thicknesses of the points
};

/// The plateau and the share of closed cells' air that give the points back best, by the energy balance of
/// each drop (static_kpa * (height / thickness + strain) = energy up to that strain, g = stress / static_kpa
/// - 1). Fails (kind usage) with fewer than five points or more than 200, points that are no numbers above 0,
/// and where the worst residual is above 15 %: then the sentence shows them.
[[nodiscard]] Result<CushionFit> fit_cushion_points(std::span<const CushionPoint> points);

}  // namespace snug
