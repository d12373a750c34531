#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/result.h"
#include "snug/mesh/left_out.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// What a reader collects: coordinates as the file has them, not yet recentred. In float where the file holds
/// floats, which takes half the memory, in double otherwise; both give the same mesh.
template <class T>
struct RawMeshOf {
    std::vector<Vec3<T>> vertices;
    std::vector<Triangle> triangles;
    /// Of a reader: `faces`, those that it has left out by itself, and what else it noted. finish() adds what
    /// it leaves out.
    ReadNotes read{};
};
using RawMesh = RawMeshOf<double>;

/// Where a mesh within the box has its origin: zero, so that the file's own floats stay as they are, unless
/// it lies so far away that they would not; then the box's centre.
[[nodiscard]] Vec3d origin_for(const Box3d& box);
/// Cuts a polygon into triangles and appends them. Concave polygons are cut inside their outline (ear
/// clipping in the plane of their area vector); where that fails, a fan. One that is no face (fewer than
/// three corners, or four and more with one that is not usable()) is counted in `left_out_faces` instead; of
/// a triangle finish() sees that. For float and double.
template <class T>
void append_polygon(RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners);

/// Drops triangles with a corner that is not usable() and unused vertices, moves the origin into the object
/// where it lies far from zero, and rounds to float. Fails without triangles (a point cloud is named as
/// such), where more than half of the faces are left out, and with more than 2^32 - 2 vertices. All indices
/// must be in range already. For float and double.
template <class T>
[[nodiscard]] Result<Mesh> finish(RawMeshOf<T> raw);

/// The same for points without triangles: all that are usable() are kept in their order, and Mesh::is_cloud()
/// holds. For float and double.
template <class T>
[[nodiscard]] Result<Mesh> finish_cloud(RawMeshOf<T> raw);

}  // namespace snug
