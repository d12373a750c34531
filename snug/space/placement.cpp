#include "snug/space/placement.h"

#include <span>

#include "snug/object/turned_bounds.h"

namespace snug {
namespace {

Box3d turned_bounds(std::span<const Vec3f> vertices, const Rotation& rotation) {
    Box3d box;
    for (const Vec3f& v : vertices) box.include(rotation(vec_cast<double>(v)));
    return box;
}

Placement centred(const Rotation& rotation, Box3d turned_body, const Box3d& turned_caps, Vec3d offset_mm) {
    Placement placement;
    placement.rotation = rotation;
    placement.shift = offset_mm - turned_body.centre();
    turned_body.include(turned_caps);
    placement.bounds = {turned_body.min + placement.shift, turned_body.max + placement.shift};
    return placement;
}

}  // namespace

Placement place(const Box3d& turned, const Rotation& rotation, Vec3d offset_mm) {
    return centred(rotation, turned, {}, offset_mm);
}

Placement place(const Mesh& mesh, Vec3d rotation_deg, Vec3d offset_mm) {
    const std::span<const Vec3f> vertices(mesh.vertices.data(), mesh.vertices.size());
    const Rotation rotation = rotation_from_euler(rotation_deg);
    return centred(rotation, turned_bounds(vertices.first(vertices.size() - mesh.cap_vertices), rotation),
                   turned_bounds(vertices.last(mesh.cap_vertices), rotation), offset_mm);
}

Placement place(const PreparedSurface& surface, Vec3d rotation_deg, Vec3d offset_mm) {
    const Rotation rotation = rotation_from_euler(rotation_deg);
    return centred(rotation, turned_bounds(surface.body, rotation), turned_bounds(surface.caps, rotation),
                   offset_mm);
}

}  // namespace snug
