#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// What a reader collects: coordinates in double as the file has them, not yet recentred.
struct RawMesh {
    std::vector<Vec3d> vertices;
    std::vector<Triangle> triangles;
};

/// Cuts a polygon with any number of corners >= 3 into triangles and appends them. Concave polygons are cut
/// inside their outline (ear clipping in the plane of their area vector); where that fails, a fan.
void append_polygon(RawMesh& mesh, std::span<const std::uint32_t> corners);

/// Drops unused vertices, moves the origin into the object where it lies far from zero, and rounds to float.
/// Fails without triangles (a point cloud is named as such), with coordinates that are not finite or beyond
/// float, and with more than 2^32 - 2 vertices. All indices must be in range already.
[[nodiscard]] Result<Mesh> finish(RawMesh raw);

}  // namespace snug
