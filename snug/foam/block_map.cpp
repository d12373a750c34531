#include "snug/foam/block_map.h"

#include "snug/depth/cells.h"

namespace snug {

BlockMap block_map(const DepthMap& depths, const DesignSpace& space, Reach reach) {
    const GrownCells along_x(space, 0, {});
    BlockMap blocks(depths.ny(), depths.nz());
    for (std::size_t column = 0; column < depths.size(); ++column) {
        const DepthRange& depth = depths[column];
        if (depth.none()) continue;
        const CellRange cut = along_x.meeting(depth.lowest - reach.mm.x, depth.highest + reach.mm.x);
        blocks[column] = {static_cast<std::int16_t>(cut.first), static_cast<std::int16_t>(cut.last + 1)};
    }
    return blocks;
}

}  // namespace snug
