#pragma once

#include "snug/base/result.h"
#include "snug/design/mould_options.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/workshop_pack.h"

namespace snug {

/// The negative of each half as an open box to print and to pour foam or silicone into. Fails (kind usage)
/// for options out of range, a bed smaller than a block, or more parts than anyone prints.
[[nodiscard]] Result<WorkshopPack> mould_pack(const FoamDesign& design, const MouldOptions& options,
                                              const PrintOptions& print);

}  // namespace snug
