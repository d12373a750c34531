#pragma once

#include <cstdint>

#include "snug/base/grid.h"
#include "snug/foam/depth_map.h"
#include "snug/foam/design_space.h"

namespace snug {

/// The blocks first..end-1 that are cut away in one column, counted from -x; none where first >= end.
struct CutRun {
    std::int16_t first = 0;
    std::int16_t end = 0;

    [[nodiscard]] bool none() const { return first >= end; }
    [[nodiscard]] int blocks() const { return none() ? 0 : end - first; }
    friend bool operator==(CutRun, CutRun) = default;
};

/// The complement of the paper's BM (section 3.2): the run of blocks that each column loses. A block from a
/// to b along x is cut if and only if highest + reach >= a and lowest - reach <= b.
using BlockMap = Grid<CutRun>;
[[nodiscard]] BlockMap block_map(const DepthMap& depths, const DesignSpace& space, Reach reach);

}  // namespace snug
