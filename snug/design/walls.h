#pragma once

#include <array>

#include "snug/base/vec.h"

namespace snug {

/// mm of foam on each side, in the order of FitReport::wall_mm: floor (-x), roof (+x), back (-y), front (+y),
/// left (-z), right (+z).
using Walls = std::array<double, 6>;

[[nodiscard]] constexpr Walls equal_walls(double mm) {
    return {mm, mm, mm, mm, mm, mm};
}

/// The same wall on both sides of each axis.
[[nodiscard]] constexpr Walls paired_walls(Vec3d mm) {
    return {mm.x, mm.x, mm.y, mm.y, mm.z, mm.z};
}

[[nodiscard]] inline bool are_equal(const Walls& walls) {
    return walls == equal_walls(walls[0]);
}

}  // namespace snug
