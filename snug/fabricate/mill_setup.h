#pragma once

#include <string>
#include <vector>

#include "snug/fabricate/mill_plan.h"

namespace snug {

/// "lower.nc", "lid-outside.nc"
[[nodiscard]] std::string mill_file_name(const MillPlan& plan);
/// "LOWER, cavity up"
[[nodiscard]] std::string mill_title(const MillPlan& plan);

/// The set-up sheet: stock, cutter, feeds, the order of work, and each side from above with its depths, pins
/// and way round.
[[nodiscard]] DrawingDocument mill_setup(const FoamDesign& design, const MillPlans& plans,
                                         const MillOptions& options, const std::vector<PackFigure>& figures);

}  // namespace snug
