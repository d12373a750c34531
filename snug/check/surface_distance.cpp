#include "snug/check/surface_distance.h"

#include <limits>
#include <utility>

namespace snug {
namespace {

Vec3d unturned(const Rotation& rotation, Vec3d p) {
    return rotation.row[0] * p.x + rotation.row[1] * p.y + rotation.row[2] * p.z;
}

}  // namespace

Result<SurfaceDistance> SurfaceDistance::build(const Mesh& mesh, const Progress& progress) {
    std::vector<Vec3d> vertices;
    vertices.reserve(mesh.vertices.size());
    for (const Vec3f& vertex : mesh.vertices) vertices.push_back(vec_cast<double>(vertex));
    auto tree = TriangleTree::build(vertices, mesh.triangles, progress);
    if (!tree) return tl::unexpected(tree.error());
    return SurfaceDistance(std::move(vertices), std::move(*tree));
}

double SurfaceDistance::at(Vec3d place, const Placement& placement) const {
    const Vec3d own = unturned(placement.rotation, place - placement.shift);
    return tree_.nearest(own, std::numeric_limits<double>::infinity()).distance;
}

}  // namespace snug
