#pragma once

#include <algorithm>
#include <limits>

#include "snug/base/vec.h"

namespace snug {

/// Axis-aligned bounding box, bounds included. A new box is empty (min > max) and grows by include().
struct Box3d {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Vec3d min{kInfinity, kInfinity, kInfinity};
    Vec3d max{-kInfinity, -kInfinity, -kInfinity};

    [[nodiscard]] constexpr bool empty() const { return min.x > max.x; }
    [[nodiscard]] constexpr Vec3d size() const { return empty() ? Vec3d{} : max - min; }
    [[nodiscard]] constexpr Vec3d centre() const { return (min + max) * 0.5; }
    [[nodiscard]] constexpr double longest_side() const {
        const Vec3d s = size();
        return std::max({s.x, s.y, s.z});
    }

    [[nodiscard]] constexpr bool contains(Vec3d p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y && min.z <= p.z && p.z <= max.z;
    }

    constexpr void include(Vec3d p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
    }
    constexpr void include(const Box3d& other) {
        if (other.empty()) return;
        include(other.min);
        include(other.max);
    }
    friend constexpr bool operator==(const Box3d&, const Box3d&) = default;
};

}  // namespace snug
