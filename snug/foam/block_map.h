#pragma once

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/depth/depth_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// The blocks that are cut away in one column, counted from -x.
using CutRun = Run;

/// The complement of the paper's BM (section 3.2): the run of blocks that each column loses. A block from a
/// to b along x is cut if and only if highest + reach >= a and lowest - reach <= b.
using BlockMap = Grid<CutRun>;
[[nodiscard]] BlockMap block_map(const DepthMap& depths, const DesignSpace& space, Reach reach);

}  // namespace snug
