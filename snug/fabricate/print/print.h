#pragma once

#include "snug/base/result.h"
#include "snug/design/print_options.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// For a 3D printer, both halves cavity up, z up, in mm:
///   print/bed-01.3mf ...      what is printed at a time: parts in their places, blue lower, orange lid
///   print/lower-01.stl, print/lid-01.stl, print/dowel.stl    each thing on its own, from the origin
///   print/parts.csv          where each part belongs: levels, rows from BACK, columns from the left
///   print/fit-test-01.3mf, print/fit-test-01.stl ...         a flat ring to try the outline with
/// A half that is larger than the bed is cut apart along block faces; dowels join the parts. Fails (kind
/// usage) for options out of range, a bed smaller than a block, or more parts than anyone prints.
[[nodiscard]] Result<WorkshopPack> print_pack(const FoamDesign& design, const PrintOptions& options);

}  // namespace snug
