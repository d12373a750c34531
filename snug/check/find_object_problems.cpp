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
    if (depths.upper && findings.size() == before) look(*depths.upper, *cuts.upper);
}

void note_mesh(const Object& object, const Placement& placement, const ObjectOptions& options,
               std::vector<Finding>& findings) {
    find_parts(object.measure, placement, findings);
    find_read_notes(object.mesh.read, 0, options.units, findings);
    find_dropped(object.clean, options.clean, findings);
    if (object.missing.capped)
        findings.push_back({Severity::note,
                            "capped",
                            counted(object.measure.holes.size(), "hole was", "holes were") +
                                " closed before cutting; where the surface is missing its shape is a guess",
                            {}});
    if (options.cap && !object.missing.capped)
        findings.push_back(
            {Severity::note,
             "nothing_to_cap",
             "the object has no holes, so there was nothing to close: the foams are the same without --cap",
             {}});
    if (options.point_radius_mm > 0)
        findings.push_back(
            {Severity::note,
             "no_points",
             "a point radius was chosen, but the object is no cloud of points: it was not used",
             {}});
}

void note_cloud(const Object& object, const PointBalls& balls, const ObjectOptions& options,
                std::vector<Finding>& findings) {
    find_read_notes(object.mesh.read, object.read.vertices, options.units, findings);
    find_dropped(object.clean, options.clean, findings);
    std::vector<float> radius = balls.radius;
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
    if (object.missing.capped)
        findings.push_back({Severity::note,
                            "capped",
                            "what the scanner did not see was closed before cutting, down to the end of the "
                            "object where that is near; its shape there is a guess",
                            {}});
    if (options.cap && !object.missing.capped)
        findings.push_back({Severity::note,
                            "nothing_to_cap",
                            "no place was found that the scanner did not see, so there was nothing to "
                            "close: the foams are the same without --cap",
                            {}});
}

void note_stream(const Object& object, const ObjectOptions& options, std::vector<Finding>& findings) {
    find_read_notes(object.mesh.read, 0, options.units, findings);
    findings.push_back({Severity::note,
                        "streamed",
                        "the object was read in pieces: whether it is closed, in how many parts, and what it "
                        "has of undercuts is not known; foam may grow inside where it is open",
                        {}});
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

void find_object_notes(const Object& object, const Placement& placement, const ObjectOptions& options,
                       std::vector<Finding>& findings) {
    visit_kinds(
        object.surface, [&](const OwnMesh&) { note_mesh(object, placement, options, findings); },
        [&](const PointBalls& balls) { note_cloud(object, balls, options, findings); },
        [&](const StreamedTriangles&) { note_stream(object, options, findings); });
    findings.insert(findings.end(), object.findings.begin(), object.findings.end());
}

}  // namespace snug
