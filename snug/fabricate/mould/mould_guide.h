#pragma once

#include <cstddef>
#include <vector>

#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/fabricate/mould/mould_parts.h"

namespace snug {

/// What to print, the order of work, how much to pour, and each mould as it stands on the table, from above.
[[nodiscard]] DrawingDocument mould_guide(const FoamDesign& design, const std::vector<Mould>& moulds,
                                          const WorkshopOptions& options, std::size_t beds);

}  // namespace snug
