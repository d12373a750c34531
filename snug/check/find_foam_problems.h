#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/check/packing.h"
#include "snug/design/design.h"

namespace snug {

/// Whether a placed item, grown by its clearance, leaves the packing's space: `outside` (danger), with the
/// smallest space or case that would do. A face that coincides with the space's does not.
void find_outside(const Item& item, const Packing& packing, const Design& design,
                  std::vector<Finding>& findings);

/// What may be wrong with a packing's foams, whatever they are for: their walls, their pieces, their case.
void find_foam_problems(const Packing& packing, const Design& design, std::vector<Finding>& findings);

}  // namespace snug
