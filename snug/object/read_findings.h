#pragma once

#include <optional>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// What a reader left out or missed, and a unit that does not count since the file states its own: `left_out`
/// (a danger above 1 % of the faces or points), `left_out_objects` (of a bundle), `no_end` and `unit_stated`.
/// `left`: points of a cloud that were read; of no account for a mesh.
void find_read_notes(const ReadNotes& read, std::size_t left, const std::optional<Unit>& units,
                     std::vector<Finding>& findings);

}  // namespace snug
