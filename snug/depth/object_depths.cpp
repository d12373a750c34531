#include "snug/depth/object_depths.h"

#include <cstddef>
#include <utility>

#include "snug/base/visit_kinds.h"
#include "snug/depth/cloud_depth_map.h"
#include "snug/depth/streamed_surface.h"

namespace snug {
namespace {

/// `see(reach)`: the depth map of a surface grown by so much.
template <class See>
ObjectDepths both_halves(const CutOptions& cut, const See& see) {
    const auto seen = [&](Vec3d clearance_mm) {
        const Reach grown = reach(clearance_mm, cut.cut_on_touch);
        return HalfDepths{see(grown), grown};
    };
    const Clearance clearance = cut.whole_clearance_mm();
    ObjectDepths depths{seen(clearance.lower), {}};
    if (!clearance.same_in_both()) depths.upper = seen(clearance.upper);
    return depths;
}

DepthMap balls_and_caps(const PointBalls& balls, const MissingSurface& missing, const Placement& placement,
                        const DesignSpace& space, Reach grown) {
    DepthMap depths = cloud_depth_map(balls.cloud, balls.radius, placement, space, grown);
    if (missing.capped) {
        const DepthMap caps = depth_map(missing.spans, placement, space, grown);
        for (std::size_t column = 0; column < depths.size(); ++column) depths[column].include(caps[column]);
    }
    return depths;
}

Result<ObjectDepths> stream_depths(const StreamedTriangles& streamed, bool mark, const Placement& placement,
                                   const DesignSpace& space, const CutOptions& cut,
                                   const Progress& progress) {
    const Clearance clearance = cut.whole_clearance_mm();
    const bool both = clearance.same_in_both();
    const auto see = [&](Vec3d clearance_mm, MetCubes* cubes, const Progress& told) -> Result<HalfDepths> {
        const Reach grown = reach(clearance_mm, cut.cut_on_touch);
        auto depths = depth_map(streamed.stream, streamed.to_object, placement, space, grown, cubes, told);
        if (!depths) return tl::unexpected(depths.error());
        return HalfDepths{std::move(*depths), grown};
    };
    auto lower =
        see(clearance.lower, mark ? streamed.cubes.get() : nullptr, part_of(progress, 0, both ? 1 : 0.5));
    if (!lower) return tl::unexpected(lower.error());
    ObjectDepths depths{std::move(*lower), {}};
    if (both) return depths;
    auto upper = see(clearance.upper, nullptr, part_of(progress, 0.5, 1));
    if (!upper) return tl::unexpected(upper.error());
    depths.upper = std::move(*upper);
    return depths;
}

}  // namespace

ObjectDepths object_depths(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                           const CutOptions& cut) {
    return both_halves(cut, [&](Reach grown) { return depth_map(mesh, placement, space, grown); });
}

ObjectDepths object_depths(const PreparedSurface& surface, const Placement& placement,
                           const DesignSpace& space, const CutOptions& cut) {
    return both_halves(cut, [&](Reach grown) { return depth_map(surface, placement, space, grown); });
}

Result<ObjectDepths> object_depths(const Object& object, const Placement& placement, const DesignSpace& space,
                                   const CutOptions& cut, const Progress& progress) {
    return visit_kinds(
        object.surface,
        [&](const OwnMesh&) -> Result<ObjectDepths> {
            if (object.prepared) return object_depths(*object.prepared, placement, space, cut);
            return object_depths(object.mesh, placement, space, cut);
        },
        [&](const PointBalls& balls) -> Result<ObjectDepths> {
            return both_halves(cut, [&](Reach grown) {
                return balls_and_caps(balls, object.missing, placement, space, grown);
            });
        },
        [&](const StreamedTriangles& streamed) {
            const bool mark = object.mesh.triangles.empty();
            return stream_depths(streamed, mark, placement, space, cut, progress);
        });
}

}  // namespace snug
