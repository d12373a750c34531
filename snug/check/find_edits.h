#pragma once

#include <vector>

#include "snug/base/finding.h"
#include "snug/check/packing.h"
#include "snug/design/hand_edit.h"

namespace snug {

/// Edits by hand that do not apply: `edits_unapplied` (note), which names the first; foam that was put back
/// into the clearance: `edit_in_clearance` (warning), with the least that is left.
void find_edits(const Packing& packing, const HandEdits& edits, std::vector<Finding>& findings);

}  // namespace snug
