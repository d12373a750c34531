#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/design/design.h"

namespace snug {

/// What is known of a pack's materials near museum objects, as a note: of the foam that the design names and
/// of what its way of working brings along. Nothing where the design is not for a museum object.
void find_near_collections(const Design& design, std::vector<Finding>& findings);

}  // namespace snug
