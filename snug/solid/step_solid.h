#pragma once

#include <vector>

#include "snug/base/vec.h"

namespace snug {

/// A solid in steps, see lattice.h: x counts the height, y and z lie in plan.
struct StepSolid {
    std::vector<Vec3i> points;
    std::vector<Triangle> triangles;  ///< outward where x, y and z are right-handed

    [[nodiscard]] bool empty() const { return triangles.empty(); }
};

/// In steps cubed.
[[nodiscard]] inline double volume_of(const StepSolid& solid) {
    double six_volumes = 0;
    for (const Triangle& t : solid.triangles) {
        const Vec3d a = vec_cast<double>(solid.points[t[0]]), b = vec_cast<double>(solid.points[t[1]]);
        six_volumes += dot(a, cross(b, vec_cast<double>(solid.points[t[2]])));
    }
    return six_volumes / 6;
}

}  // namespace snug
