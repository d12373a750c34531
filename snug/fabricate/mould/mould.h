#pragma once

#include "snug/base/result.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// The negative of each half as an open box to print, z up, and to pour foam or silicone into, in mm:
///   mould/bed-01.3mf ...     what is printed at a time: parts in their places, blue lower, orange lid
///   mould/lower-01.stl, mould/lid-01.stl, mould/dowel.stl    each thing on its own, from the origin
///   mould/parts.csv          where each part's least corner stands in the assembled mould
///   mould-guide              a document: order of work, and each mould from above
/// A half is cast cavity down, and turned over it is the half, never mirrored; it may be smaller by the
/// draft, never larger. Fails (kind usage) for options out of range, a bed smaller than a block with its
/// walls, or more parts than anyone prints. Uses of the options the mould, the print and the paper.
[[nodiscard]] Result<WorkshopPack> mould_pack(const FoamDesign& design, const WorkshopOptions& options);

}  // namespace snug
