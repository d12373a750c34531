#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "snug/base/vec2.h"

namespace snug {

/// Cuts a closed polygon of at least three corners, counter-clockwise and with edges in any direction, into
/// triangles by cutting off ears (Meisters, Polygons have ears, 1975), and appends them as places of corners.
/// Corners given twice, along straight sides and at bridges to holes are fine; where no ear is left, a corner
/// whose triangle has at most `flat` of twice an area goes as if it were one (below 0: none). False, with
/// some triangles appended, where the polygon crosses itself. The time goes with the square of the corners:
/// faces that run along the lines of a grid are for RowTriangulator, which follows their number alone.
[[nodiscard]] bool clip_ears(std::span<const Vec2d> polygon, double flat,
                             std::vector<std::array<std::size_t, 3>>& triangles);

}  // namespace snug
