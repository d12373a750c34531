#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Points of a surface, coordinate by coordinate, so that many are turned at a time.
struct SurfacePoints {
    std::vector<float> x, y, z;

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// Points that lie on the mesh, about `spacing` mm apart: every cube of that side which the surface's samples
/// meet keeps the one that lies furthest out. The same points everywhere.
[[nodiscard]] SurfacePoints surface_points(const Mesh& mesh, double spacing);

/// Some of the points, in the same way.
[[nodiscard]] SurfacePoints thinned(const SurfacePoints& points, double spacing);

/// The area of all triangles, mm2.
[[nodiscard]] double surface_area(const Mesh& mesh);

}  // namespace snug
