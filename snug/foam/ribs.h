#pragma once

#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// Cuts away what stands of either half between cavities in less than `least_mm` along y or z: each half
/// becomes the highest that rectangles of that size, in whole blocks, fit under (a grey-scale opening,
/// Serra 1982). Foam on the case's side holds to the case and counts as wide. Returns the number of blocks
/// that were cut.
long long cut_thin_ribs(BlockMap& blocks, const DesignSpace& space, int parting_level, double least_mm);

}  // namespace snug
