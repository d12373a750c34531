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

Placement place(const Mesh& mesh, Vec3d rotation_deg, Vec3d offset_mm) {
    const std::span<const Vec3f> vertices(mesh.vertices.data(), mesh.vertices.size());
    Placement placement;
    placement.rotation = rotation_from_euler(rotation_deg);
    Box3d turned = turned_bounds(vertices.first(vertices.size() - mesh.cap_vertices), placement.rotation);
    placement.shift = offset_mm - turned.centre();
    turned.include(turned_bounds(vertices.last(mesh.cap_vertices), placement.rotation));
    placement.bounds = {turned.min + placement.shift, turned.max + placement.shift};
    return placement;
}

}  // namespace snug
