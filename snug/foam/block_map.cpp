#include "snug/foam/block_map.h"

#include <algorithm>
#include <vector>

namespace snug {

BlockMap block_map(const DepthMap& depths, const DesignSpace& space, Reach reach) {
    const int nx = space.blocks.x;
    std::vector<double> faces(static_cast<std::size_t>(nx) + 1);
    for (int i = 0; i <= nx; ++i) faces[static_cast<std::size_t>(i)] = space.face(0, i);

    BlockMap blocks(depths.ny(), depths.nz());
    for (std::size_t column = 0; column < depths.size(); ++column) {
        const DepthRange& depth = depths[column];
        if (depth.none()) continue;
        // Block i reaches from faces[i] to faces[i + 1]: the first whose far face is not below the object,
        // and one past the last whose near face is not above it.
        const auto far = std::lower_bound(faces.begin() + 1, faces.end(), depth.lowest - reach.mm);
        const auto near = std::upper_bound(faces.begin(), faces.end() - 1, depth.highest + reach.mm);
        blocks[column] = {static_cast<std::int16_t>(far - faces.begin() - 1),
                          static_cast<std::int16_t>(near - faces.begin())};
    }
    return blocks;
}

}  // namespace snug
