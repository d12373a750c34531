#include "snug/object/prepare.h"

#include <algorithm>
#include <utility>

#include "snug/mesh/cap.h"
#include "snug/object/prepare_cloud.h"
#include "snug/object/scale_to_mm.h"

namespace snug {

Result<Object> prepare(Mesh mesh, const Design& design) {
    const Vec3d size = bounds(mesh).size();
    if (std::max({size.x, size.y, size.z}) <= 0) return fail(ErrorKind::input, say("object.one_point"));
    if (!mesh.read.in_mm)
        if (const auto error = implausible_size(size, design)) return tl::unexpected(*error);

    Object object;
    object.options = design.object;
    const ReadNotes read = mesh.read;
    object.read = {mesh.vertices.size(), mesh.triangles.size()};
    const double mm_per_unit = millimetres_per_unit(size, design.object, mesh.read.in_mm);
    auto clean = cleaned(scaled(std::move(mesh), mm_per_unit), design.object.clean);
    if (!clean) return tl::unexpected(clean.error());
    object.clean = std::move(clean->report);
    if (clean->mesh.is_cloud()) {
        auto cloud = prepare_cloud(std::move(object), std::move(clean->mesh), design);
        if (cloud) cloud->mesh.read = read;
        return cloud;
    }
    object.mesh = std::move(clean->mesh);
    object.measure = measure(object.mesh);
    if (object.clean.parts.empty()) object.clean.parts = part_shares(object.mesh, object.measure);
    object.missing.capped = design.object.cap && !object.measure.holes.empty();
    if (object.missing.capped)
        object.mesh = capped(object.mesh, object.measure.holes);
    else
        object.missing.spans = span_of_loops(object.mesh, object.measure.holes);
    object.mesh.read = read;
    return object;
}

void prepare_for_many(Object& object) {
    if (!object.prepared) object.prepared = prepare_surface(object.mesh);
}

}  // namespace snug
