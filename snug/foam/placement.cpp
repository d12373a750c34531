#include "snug/foam/placement.h"

#include <span>

namespace snug {
namespace {

Box3d turned_bounds(std::span<const Vec3f> vertices, const Rotation& rotation) {
    Box3d box;
    for (const Vec3f& v : vertices) box.include(rotation(vec_cast<double>(v)));
    return box;
}

}  // namespace

Placement place(const Mesh& mesh, Vec3d rotation_deg, Vec3d offset_mm, std::size_t own_vertices) {
    const std::span<const Vec3f> vertices(mesh.vertices);
    Placement placement;
    placement.rotation = rotation_from_euler(rotation_deg);
    Box3d turned = turned_bounds(vertices.first(own_vertices), placement.rotation);
    placement.shift = offset_mm - turned.centre();
    turned.include(turned_bounds(vertices.subspan(own_vertices), placement.rotation));
    placement.bounds = {turned.min + placement.shift, turned.max + placement.shift};
    return placement;
}

Placement place(const Mesh& mesh, Vec3d rotation_deg, Vec3d offset_mm) {
    return place(mesh, rotation_deg, offset_mm, mesh.vertices.size());
}

}  // namespace snug
