#include "snug/space/place_object.h"

#include <cstddef>

#include "snug/base/visit_kinds.h"
#include "snug/object/streamed_bounds.h"

namespace snug {
namespace {

/// The turned bounding box is that of the balls.
Placement place_balls(const PointBalls& balls, Vec3d rotation_deg, Vec3d offset_mm) {
    const Rotation rotation = rotation_from_euler(rotation_deg);
    Box3d turned;
    for (std::size_t i = 0; i < balls.cloud.vertices.size(); ++i) {
        const Vec3d centre = rotation(vec_cast<double>(balls.cloud.vertices[i]));
        const auto r = static_cast<double>(balls.radius[i]);
        turned.include(Box3d{centre - Vec3d{r, r, r}, centre + Vec3d{r, r, r}});
    }
    return place(turned, rotation, offset_mm);
}

Result<Placement> place_stream(const StreamedTriangles& streamed, Vec3d rotation_deg, Vec3d offset_mm,
                               const Progress& progress) {
    const Rotation rotation = rotation_from_euler(rotation_deg);
    if (rotation_deg == streamed.rotation_deg) return place(streamed.turned, rotation, offset_mm);
    const auto bounds = streamed_bounds(streamed.stream, streamed.to_object, rotation, progress);
    if (!bounds) return tl::unexpected(bounds.error());
    return place(bounds->turned, rotation, offset_mm);
}

}  // namespace

Result<Placement> place(const Object& object, Vec3d rotation_deg, Vec3d offset_mm, const Progress& progress) {
    return visit_kinds(
        object.surface,
        [&](const OwnMesh&) -> Result<Placement> {
            if (object.prepared) return place(*object.prepared, rotation_deg, offset_mm);
            return place(object.mesh, rotation_deg, offset_mm);
        },
        [&](const PointBalls& balls) -> Result<Placement> {
            return place_balls(balls, rotation_deg, offset_mm);
        },
        [&](const StreamedTriangles& streamed) {
            return place_stream(streamed, rotation_deg, offset_mm, progress);
        });
}

}  // namespace snug
