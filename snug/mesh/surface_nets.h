#pragma once

#include <functional>

#include "snug/base/box.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// A solid given by a number for each point: negative inside, positive outside, about the distance in mm near
/// the surface.
using Field = std::function<double(Vec3d)>;

/// The surface of a solid that lies well within `box`, as one mesh by surface nets (Gibson 1998, Constrained
/// Elastic Surface Nets): a vertex in each cell of a grid that the surface crosses, drawn onto the surface,
/// and a quadrilateral, cut into two triangles, around each grid edge that it crosses. Closed and outward
/// because every such edge is inside the grid. `step` is the grid's width in mm.
[[nodiscard]] Mesh surface_nets(const Field& field, const Box3d& box, double step);

}  // namespace snug
