#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/check/fit_report.h"
#include "snug/design/clearance.h"
#include "snug/design/walls.h"
#include "snug/space/case_space.h"

namespace snug {

/// " with its clearance", where there is one.
[[nodiscard]] std::vector<Message> with_clearance(const Clearance& clearance_mm);

/// The inside (height, width, length) of the smallest case that holds an object of this size with its
/// clearance and walls in blocks of this size, without anything left over.
[[nodiscard]] Vec3d least_inside(const CaseOptions& options, Vec3d block_mm, Vec3d object_size,
                                 const Clearance& clearance_mm, const Walls& walls);

/// The sentence for an object that leaves the foam of its case: what is in the way, and which case would do.
[[nodiscard]] Message too_small(const CaseSpace& fitted, Vec3d object_size, const Clearance& clearance_mm,
                                const Walls& walls);
/// The same for several items, which take `room` together; `clearance`: with_clearance() of them.
[[nodiscard]] Message too_small_for_items(const CaseSpace& fitted, const Box3d& room,
                                          std::vector<Message> clearance, const Walls& walls);

/// An object that reaches into a rounded corner or leaning wall: `leaves_case` (danger). Foams that do not
/// part at the lid's line: `off_lid_line` (note).
void find_case_problems(const CaseSpace& fitted, const FitReport& fit, int parting_level,
                        std::vector<Finding>& findings);

}  // namespace snug
