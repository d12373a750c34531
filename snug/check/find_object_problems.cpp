#include "snug/check/find_object_problems.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "snug/base/text.h"
#include "snug/base/visit_kinds.h"
#include "snug/check/find_problems.h"
#include "snug/object/read_findings.h"

namespace snug {
namespace {

/// `look(half, cut)` at the lower half, and where that is well at the upper, if it differs.
template <class Look>
void in_either_half(const ObjectDepths& depths, const HalfCuts& cuts, const std::vector<Finding>& findings,
                    const Look& look) {
    const std::size_t before = findings.size();
    look(depths.lower, cuts.lower);
    if (depths.upper && cuts.upper && findings.size() == before) look(*depths.upper, *cuts.upper);
}

void note_mesh(const Object& object, const Placement& placement, const ObjectOptions& options,
               std::vector<Finding>& findings) {
    find_parts(object.measure, placement, findings);
    find_read_notes(object.mesh.read, 0, options.units, findings);
    find_dropped(object.clean, options.clean, findings);
    if (object.missing.capped)
        findings.push_back({Severity::note, say("capped", {{"holes", object.measure.holes.size()}})});
    if (options.cap && !object.missing.capped) findings.push_back({Severity::note, say("nothing_to_cap")});
    if (options.point_radius_mm > 0) findings.push_back({Severity::note, say("no_points")});
}

void note_cloud(const Object& object, const PointBalls& balls, const ObjectOptions& options,
                std::vector<Finding>& findings) {
    find_read_notes(object.mesh.read, object.read.vertices, options.units, findings);
    find_dropped(object.clean, options.clean, findings);
    std::vector<float> radius = balls.radius;
    const auto middle = radius.begin() + static_cast<std::ptrdiff_t>(radius.size() / 2);
    std::nth_element(radius.begin(), middle, radius.end());
    findings.push_back({Severity::note, say("cloud", {{"points", radius.size()},
                                                      {"radius", number(static_cast<double>(*middle), 2)}})});
    if (object.missing.capped) findings.push_back({Severity::note, say("capped/cloud")});
    if (options.cap && !object.missing.capped)
        findings.push_back({Severity::note, say("nothing_to_cap/cloud")});
}

void note_stream(const Object& object, const ObjectOptions& options, std::vector<Finding>& findings) {
    find_read_notes(object.mesh.read, 0, options.units, findings);
    findings.push_back({Severity::note, say("streamed")});
}

}  // namespace

void find_object_problems(const Object& object, const Placement& placement, const DesignSpace& space,
                          const ObjectDepths& depths, const HalfCuts& cuts, std::vector<Finding>& findings) {
    const auto find_holes = [&](const HalfDepths& half, const BlockMap& cut) {
        find_open_holes(object.missing.spans, placement, space, half.reach, half.depths, cut, findings);
    };
    visit_kinds(
        object.surface,
        [&](const OwnMesh&) {
            in_either_half(depths, cuts, findings, [&](const HalfDepths& half, const BlockMap& cut) {
                find_holes(half, cut);
                find_uncut_parts(object.mesh, object.measure, object.missing.capped, placement, space,
                                 half.reach, cut, findings);
            });
        },
        [&](const PointBalls&) {
            if (!object.missing.capped) in_either_half(depths, cuts, findings, find_holes);
        },
        [](const StreamedTriangles&) {});
}

void find_object_notes(const Object& object, const Placement& placement, std::vector<Finding>& findings) {
    const ObjectOptions& options = object.options;
    visit_kinds(
        object.surface, [&](const OwnMesh&) { note_mesh(object, placement, options, findings); },
        [&](const PointBalls& balls) { note_cloud(object, balls, options, findings); },
        [&](const StreamedTriangles&) { note_stream(object, options, findings); });
    findings.insert(findings.end(), object.findings.begin(), object.findings.end());
}

}  // namespace snug
