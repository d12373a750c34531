#pragma once

#include <span>

#include "snug/check/pads.h"
#include "snug/design/stress_curve.h"

namespace snug {

/// The greatest mean pressure over a square of 1 cm2 after a travel, kPa: of squares at steps of half their
/// side along both axes across the way, the foam's columns counting by their areas. So ridges see more.
[[nodiscard]] double most_mean_kpa(std::span<const PadColumn> columns, double travel_mm,
                                   const StressCurve& curve);

}  // namespace snug
