#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/foam/object_cut.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// Items that are of no common group and between whose cut columns less foam stands than is wanted, in mm:
/// `items_near` (danger), one for each pair of them, with how far to shift. The distance of two columns is
/// the larger of those along y and z and, of different layers, along x from what the lower item cuts of the
/// foam above it up to what the upper item cuts of the foam below it. `cuts`: what each item cuts by itself.
/// Those that may share a pocket, by their group or since no foam is wanted between them, and do, whose
/// placed boxes overlap: `items_overlap` (warning). Whether their surfaces meet is not computed.
void find_near_items(const std::vector<Item>& items, const std::vector<HalfCuts>& cuts,
                     const DesignSpace& space, double between_mm, std::vector<Finding>& findings);

}  // namespace snug
