#include "snug/space/fitted_space.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

constexpr double kBlockRounding = 1e-9;

double wall_blocks(const Walls& walls, int side, Vec3d block_mm) {
    return std::ceil((walls[static_cast<std::size_t>(side)] - kBlockRounding) / block_mm[side / 2]);
}

}  // namespace

Vec3d fitted_blocks(const Box3d& grown, Vec3d block_mm, const Walls& walls) {
    Vec3d counts;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = 2 * std::max(grown.max[axis], -grown.min[axis]) - 0.02;
        const double inside = std::max(1.0, std::ceil((length - kBlockRounding) / block_mm[axis]));
        counts[axis] =
            inside + wall_blocks(walls, 2 * axis, block_mm) + wall_blocks(walls, 2 * axis + 1, block_mm);
    }
    return counts;
}

int whole_blocks(double mm, double block_mm) {
    return static_cast<int>(std::ceil(std::min(mm / block_mm, 1e6) - kBlockRounding));
}

Box3d with_room_for_notches(Box3d grown, Vec3d block_mm, const NotchOptions& options) {
    const Vec3d size = grown.size();
    const bool across_y = options.axis ? *options.axis == NotchAxis::y : size.y <= size.z;
    const int axis = across_y ? 1 : 2;
    const double room = whole_blocks(options.room_mm, block_mm[axis]) * block_mm[axis];
    grown.min[axis] -= room;
    grown.max[axis] += room;
    return grown;
}

Vec3d fitted_shift(Vec3d block_mm, const Walls& walls) {
    Vec3d shift;
    for (int axis = 0; axis < 3; ++axis)
        shift[axis] = block_mm[axis] / 2 *
                      (wall_blocks(walls, 2 * axis, block_mm) - wall_blocks(walls, 2 * axis + 1, block_mm));
    return shift;
}

Vec3d shift_between_walls(const SpaceOptions& space, bool in_case) {
    return space.blocks || in_case ? Vec3d{} : fitted_shift(space.block_mm, wanted_wall_mm(space));
}

}  // namespace snug
