#pragma once

#include <cmath>

namespace snug {

/// A point in the plane of a drawing: x to the right, y downward.
struct Vec2d {
    double x = 0, y = 0;
    friend constexpr Vec2d operator+(Vec2d a, Vec2d b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2d operator-(Vec2d a, Vec2d b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2d operator*(Vec2d a, double s) { return {a.x * s, a.y * s}; }
    friend constexpr bool operator==(const Vec2d&, const Vec2d&) = default;
};

[[nodiscard]] inline double length(Vec2d v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

}  // namespace snug
