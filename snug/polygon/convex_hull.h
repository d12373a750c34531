#pragma once

#include <vector>

#include "snug/base/vec2.h"

namespace snug {

/// Twice the area of the triangle, positive where its corners turn counterclockwise.
[[nodiscard]] double turn(Vec2d a, Vec2d b, Vec2d c);

/// The corners of the hull, counterclockwise (Andrew's monotone chain). Of fewer than three different points
/// those.
[[nodiscard]] std::vector<Vec2d> convex_hull(std::vector<Vec2d> points);

}  // namespace snug
