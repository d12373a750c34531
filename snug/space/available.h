#pragma once

#include <algorithm>
#include <cstdint>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"

// Which blocks of a design space exist: in each column one run, counted from -x.

namespace snug {

/// In a plain box all of them do.
[[nodiscard]] inline Grid<Run> all_blocks(Vec3i blocks) {
    return {blocks.y, blocks.z, {0, static_cast<std::int16_t>(blocks.x)}};
}

/// Whether no column of nx blocks is shortened by a case with rounded corners or leaning walls.
[[nodiscard]] inline bool fills_box(const Grid<Run>& available, int nx) {
    return std::all_of(available.begin(), available.end(), [&](Run run) { return run.blocks() == nx; });
}

}  // namespace snug
