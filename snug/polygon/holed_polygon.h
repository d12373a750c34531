#pragma once

#include <cstdint>
#include <vector>

#include "snug/base/vec.h"

namespace snug {

/// A corner of a loop in a plane, and the vertex that stands there.
struct LoopPoint {
    std::int64_t u = 0, v = 0;
    std::uint32_t vertex = 0;
};

using PointLoop = std::vector<LoopPoint>;

/// Triangulates what lies within loops: outer ones counter-clockwise (u to the right, v up), holes clockwise,
/// none meeting another or itself. Vertices along straight sides are fine and no triangle is flat. By cutting
/// off ears, with bridges to the holes (Eberly, Triangulation by ear clipping): for faces of some hundred
/// corners.
void triangulate_loops(const std::vector<PointLoop>& loops, std::vector<Triangle>& triangles);

}  // namespace snug
