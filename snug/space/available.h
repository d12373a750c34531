#pragma once

#include <cstddef>
#include <cstdint>

#include "snug/base/grid.h"
#include "snug/base/run.h"

namespace snug {

/// The run of blocks that exist in each column, counted from -x: all but those that would stick out of a case
/// with rounded corners or leaning walls. An empty grid stands for all blocks of the space.
using Available = Grid<Run>;

/// The blocks of the column that exist, of nx.
[[nodiscard]] inline Run available_in(const Available& available, std::size_t column, int nx) {
    return available.size() == 0 ? Run{0, static_cast<std::int16_t>(nx)} : available[column];
}

}  // namespace snug
