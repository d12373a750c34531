#include "snug/pack_cloud.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/check/cloud_rims.h"
#include "snug/check/find_problems.h"
#include "snug/depth/cloud_depth_map.h"
#include "snug/foam/object_cut.h"
#include "snug/foam/space_for.h"
#include "snug/mesh/cap.h"
#include "snug/mesh/shell.h"
#include "snug/object/cloud_places.h"
#include "snug/object/point_radius.h"
#include "snug/object/read_findings.h"
#include "snug/pack_placed.h"

namespace snug {
namespace {

Box3d ball(const Object& object, std::size_t point) {
    const Vec3d centre = vec_cast<double>(object.cloud.vertices[point]);
    const auto r = static_cast<double>(object.point_radius[point]);
    return {centre - Vec3d{r, r, r}, centre + Vec3d{r, r, r}};
}

/// Points in the same place have the same ball.
Mesh stand_in(const Object& object, const CloudPlaces& places) {
    Box3d box;
    for (std::size_t i = 0; i < places.size(); ++i) box.include(ball(object, places.vertex_of(i)));
    MetCubes cubes(box, kStandInCubes);
    for (std::size_t i = 0; i < places.size(); ++i) cubes.mark(ball(object, places.vertex_of(i)));
    return cubes.shell();
}

HalfDepths half_depths(const Object& object, const Placement& placement, const DesignSpace& space,
                       Vec3d clearance_mm, bool cut_on_touch) {
    const Reach grown = reach(clearance_mm, cut_on_touch);
    DepthMap depths = cloud_depth_map(object.cloud, object.point_radius, placement, space, grown);
    if (object.capped) {
        const DepthMap caps = depth_map(object.hole_spans, placement, space, grown);
        for (std::size_t column = 0; column < depths.size(); ++column) depths[column].include(caps[column]);
    }
    return {std::move(depths), grown};
}

void note_cloud(const Object& object, std::vector<Finding>& findings) {
    std::vector<float> radius = object.point_radius;
    const auto middle = radius.begin() + static_cast<std::ptrdiff_t>(radius.size() / 2);
    std::nth_element(radius.begin(), middle, radius.end());
    findings.push_back(
        {Severity::note,
         "cloud",
         "a cloud of " + counted(radius.size(), "point", "points") +
             ": each counts as a ball, half of them of " + number(static_cast<double>(*middle), 2) +
             " mm or less in radius (--point-radius sets it). Volume, parts, gaps and undercuts "
             "are not known",
         {}});
    if (object.capped)
        findings.push_back({Severity::note,
                            "capped",
                            "what the scanner did not see was closed before cutting, down to the end of the "
                            "object where that is near; its shape there is a guess",
                            {}});
}

}  // namespace

Result<Object> prepare_cloud(Object object, Mesh cloud, const Design& design) {
    object.kind = ObjectKind::cloud;
    object.cloud = std::move(cloud);
    object.measure.bounds = bounds(object.cloud);
    const CloudPlaces places(object.cloud);
    auto radii = point_radii(object.cloud, places, design.object.point_radius_mm);
    if (!radii) return tl::unexpected(radii.error());
    object.point_radius = std::move(radii->radius);
    object.mesh = stand_in(object, places);
    const auto rims = cloud_rims(places);
    object.capped = design.object.cap && !rims.empty();
    object.hole_spans = object.capped ? capped(object.cloud, rims) : span_of_loops(object.cloud, rims);
    return object;
}

Result<Packing> pack_cloud(const Object& object, const Design& design) {
    const Clearance clearance = design.cut.whole_clearance_mm();
    PackSteps steps;
    steps.depths = [&](const Placement& placement, const DesignSpace& space) -> Result<ObjectDepths> {
        const bool touch = design.cut.cut_on_touch;
        ObjectDepths depths{half_depths(object, placement, space, clearance.lower, touch), {}};
        if (!clearance.same_in_both())
            depths.upper = half_depths(object, placement, space, clearance.upper, touch);
        return depths;
    };
    steps.find_object_problems = [&](const Packing& packing, const ObjectDepths& depths, const HalfCuts& cuts,
                                     std::vector<Finding>& findings) {
        if (object.capped) return;
        const std::size_t before = findings.size();
        const auto look = [&](const HalfDepths& half, const BlockMap& cut) {
            find_open_holes(object.hole_spans, packing.placement, packing.space, half.reach, half.depths, cut,
                            findings);
        };
        look(depths.lower, cuts.lower);
        if (depths.upper && findings.size() == before) look(*depths.upper, *cuts.upper);
    };
    steps.find_object_notes = [&](const Packing&, std::vector<Finding>& findings) {
        find_read_notes(object.mesh.read, object.read_vertices, design.object.units, findings);
        find_dropped(object.clean, design.object.clean, findings);
        note_cloud(object, findings);
        if (design.object.cap && !object.capped)
            findings.push_back({Severity::note,
                                "nothing_to_cap",
                                "no place was found that the scanner did not see, so there was nothing to "
                                "close: the foams are the same without --cap",
                                {}});
    };
    const bool in_case = design.case_options.inside_mm.has_value();
    const Vec3d offset = design.placement.offset_mm + shift_between_walls(design.space, in_case);
    return pack_placed(place_cloud(object.cloud, object.point_radius, design.placement.rotation_deg, offset),
                       design, steps);
}

}  // namespace snug
