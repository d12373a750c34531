#pragma once

#include <cstddef>
#include <span>

#include "snug/base/vec2.h"

// What is asked of polygons in a plane. x to the right and y upward; on a page, where y runs downward, what
// is said of counter-clockwise holds for clockwise. All of it is exact for whole coordinates up to 2^25 steps
// (32 m of snug/polygon/lattice.h), for products of their differences fit a double.

namespace snug {

/// Twice the area of the triangle a, b, c: above 0 where it turns counter-clockwise, 0 where it is flat.
[[nodiscard]] constexpr double orientation(Vec2d a, Vec2d b, Vec2d c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Above 0 for a closed polygon that runs counter-clockwise, below 0 for one that runs clockwise.
[[nodiscard]] inline double signed_area(std::span<const Vec2d> polygon) {
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2d a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        doubled += a.x * b.y - a.y * b.x;
    }
    return 0.5 * doubled;
}

/// Whether a point lies in a closed polygon; of points on its outline some do.
[[nodiscard]] inline bool contains(std::span<const Vec2d> polygon, Vec2d p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2d a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        if ((a.y > p.y) != (b.y > p.y) && (orientation(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

/// The length of a closed polygon's outline.
[[nodiscard]] inline double perimeter(std::span<const Vec2d> polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += length(polygon[i + 1 == polygon.size() ? 0 : i + 1] - polygon[i]);
    return sum;
}

}  // namespace snug
