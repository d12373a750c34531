#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/base/vec2.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// Where a line along an axis enters an item first and leaves it last.
struct ItemLine {
    std::int32_t row = 0, column = 0;  ///< of the lattice: the same for all items
    std::uint32_t item = 0;            ///< which of them
    std::int16_t b = 0, c = 0;         ///< blocks that it runs through, along axis + 1 and axis + 2 (mod 3)
    double low = 0, high = 0;          ///< mm, design coordinates
    double u = 0, v = 0;               ///< where it stands along axis + 1 and axis + 2, mm
    double area_mm2 = 0;               ///< that it stands for
    /// Of the item's zones the one that the line meets at either end; -1: none.
    std::int16_t low_zone = -1, high_zone = -1;
};

/// How the mass of an item is spread, which is taken to be of one density.
struct MassSpread {
    double mm3 = 0;
    Vec3d centre;                   ///< design coordinates
    double xx = 0, yy = 0, zz = 0;  ///< mean squares of the distance from the centre along each axis, mm2
    double xy = 0, yz = 0, zx = 0;
    /// The mean square along a direction of length 1.
    [[nodiscard]] double along(Vec3d d) const {
        return d.x * d.x * xx + d.y * d.y * yy + d.z * d.z * zz +
               2 * (d.x * d.y * xy + d.y * d.z * yz + d.z * d.x * zx);
    }
};

/// Lines along an axis through the space, 64 a column where that is not too much work (LineLattice), each
/// with what it meets.
struct AxisLines {
    int axis = 0;
    /// Their cells, side by side from the space's low faces: so many rows along axis + 1 and columns along
    /// axis + 2 (mod 3), each of this size, mm.
    int rows = 0, columns = 0;
    Vec2d cell_mm;
    /// Of every item, in the order in which RunsAlong visits lines; of one line those that lie lower first.
    std::vector<ItemLine> lines;
    std::vector<MassSpread> spreads;  ///< of each item, as these lines see it
};

/// Of every item's mesh or stand-in. Fails only when cancelled.
[[nodiscard]] Result<AxisLines> axis_lines(std::span<const Object> objects, const std::vector<Item>& items,
                                           const DesignSpace& space, int axis, const Progress& progress = {});

}  // namespace snug
