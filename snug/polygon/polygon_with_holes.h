#pragma once

#include <cstdint>
#include <vector>

#include "snug/base/vec.h"
#include "snug/base/vec2.h"

namespace snug {

/// A corner of a polygon on the lattice, and the vertex that stands there.
struct PolygonVertex {
    Vec2d at;
    std::uint32_t vertex = 0;
};

using VertexLoop = std::vector<PolygonVertex>;

/// Triangulates polygons with holes: outer loops counter-clockwise (x to the right, y upward), holes
/// clockwise, none meeting another or itself. Vertices along straight sides are fine and no triangle is flat.
/// By bridges to the holes (Eberly, Triangulation by ear clipping) and clip_ears(): for faces of some hundred
/// corners.
void triangulate_polygons(const std::vector<VertexLoop>& loops, std::vector<Triangle>& triangles);

}  // namespace snug
