#pragma once

#include "snug/base/box.h"
#include "snug/base/vec.h"

namespace snug {

/// The box to fill: nx x ny x nz blocks of sx x sy x sz mm, centred at the origin.
struct DesignSpace {
    Vec3i blocks{30, 18, 18};
    Vec3d block_mm{15, 15, 22};

    /// Where block i begins along an axis (i = blocks[axis] is the far end of the space), in mm.
    [[nodiscard]] double face(int axis, int i) const {
        return (2.0 * i - blocks[axis]) * 0.5 * block_mm[axis];
    }

    [[nodiscard]] Vec3d size() const {
        return {blocks.x * block_mm.x, blocks.y * block_mm.y, blocks.z * block_mm.z};
    }
    [[nodiscard]] Box3d box() const { return {size() * -0.5, size() * 0.5}; }
    [[nodiscard]] double block_volume() const { return block_mm.x * block_mm.y * block_mm.z; }
    [[nodiscard]] long long block_count() const { return 1LL * blocks.x * blocks.y * blocks.z; }
};

}  // namespace snug
