#include "snug/foam/fitted_space.h"

#include <algorithm>
#include <cmath>

namespace snug {

Vec3d fitted_blocks(const Box3d& placed, Vec3d block_mm, double clearance_mm, double wall_mm) {
    constexpr double kRounding = 1e-9;
    Vec3d counts;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = std::max(placed.max[axis], -placed.min[axis]);
        const double length = 2 * (reach + clearance_mm) - 0.02;
        const double inside = std::max(1.0, std::ceil((length - kRounding) / block_mm[axis]));
        counts[axis] = inside + 2 * std::ceil((wall_mm - kRounding) / block_mm[axis]);
    }
    return counts;
}

}  // namespace snug
