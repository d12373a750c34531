#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/check/packing.h"
#include "snug/check/protection_report.h"

namespace snug {

/// Where foam bottoms: `bottoms` (danger), on each face; where what was asked for is not shown to hold:
/// `shock`; where the creep limit is passed at rest: nothing here, see find_bearing_problems(). Why nothing
/// can be told: `no_shock` (note), once.
void find_shocks(const Protection& protection, const Packing& packing, std::vector<Finding>& findings);

}  // namespace snug
