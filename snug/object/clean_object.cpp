#include "snug/object/clean_object.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "snug/base/text.h"

namespace snug {
namespace {

Result<void> drop_parts(Mesh& mesh, const CleanOptions& options, CleanReport& report) {
    const MeshMeasure measured = measure(mesh);
    const std::size_t parts = measured.parts.size();
    std::vector<bool> drop(parts, false);
    for (const int number : options.drop_parts) {
        if (static_cast<std::size_t>(number) > parts)
            return fail(ErrorKind::usage, "there is no part " + std::to_string(number) +
                                              " to drop: the object has " + counted(parts, "part", "parts") +
                                              " (see `snug inspect`)");
        drop[static_cast<std::size_t>(number) - 1] = true;
    }
    for (std::size_t p = 0; p < parts; ++p)
        if (measured.parts[p].bounds.longest_side() < options.drop_below_mm) drop[p] = true;
    if (std::find(drop.begin(), drop.end(), false) == drop.end())
        return fail(ErrorKind::usage,
                    "every part of the object would be dropped: name fewer, or a smaller size");
    report.parts = part_shares(mesh, measured);
    report.smallest_mm = measured.bounds.longest_side();
    for (const PartShare& part : report.parts)
        report.smallest_mm = std::min(report.smallest_mm, part.bounds.longest_side());
    for (const PartShare& part : report.parts)
        if (drop[part.number - 1]) report.dropped.push_back(part);
    if (!report.dropped.empty()) mesh = without_parts(mesh, measured, drop);
    return {};
}

}  // namespace

Result<Cleaned> cleaned(Mesh mesh, const CleanOptions& options) {
    Cleaned result{std::move(mesh), {}};
    if (!options.drop_parts.empty() || options.drop_below_mm > 0) {
        if (result.mesh.is_cloud())
            return fail(ErrorKind::usage, "a point cloud has no parts to drop; a plane can cut it");
        if (auto done = drop_parts(result.mesh, options, result.report); !done)
            return tl::unexpected(done.error());
    }
    if (!options.cut_plane) return result;
    const auto& [x, y, z, distance] = *options.cut_plane;
    const Vec3d normal{x, y, z};
    const double length = std::sqrt(dot(normal, normal));
    // The plane lies in the file's coordinates, the vertices relative to the mesh's origin.
    const double from_origin = distance * length - dot(normal, result.mesh.origin);
    Mesh rest = cut_off(result.mesh, normal, from_origin);
    if (rest.vertices.empty())
        return fail(ErrorKind::usage,
                    "the whole object lies behind the cutting plane: turn its direction round, or move it");
    result.report.plane_cut = !(rest.vertices == result.mesh.vertices);
    if (!result.report.plane_cut) {
        const auto along = [&](const Vec3f& p) {
            return dot(normal, vec_cast<double>(p) + result.mesh.origin) / length;
        };
        double& nearest = result.report.nearest_mm = std::numeric_limits<double>::infinity();
        double& farthest = result.report.farthest_mm = -nearest;
        for (const Vec3f& p : result.mesh.vertices) {
            nearest = std::min(nearest, along(p));
            farthest = std::max(farthest, along(p));
        }
    }
    result.mesh = std::move(rest);
    return result;
}

void find_dropped(const CleanReport& report, const CleanOptions& asked, std::vector<Finding>& findings) {
    if (asked.drop_below_mm > 0 && report.dropped.empty()) {
        findings.push_back({Severity::note,
                            "nothing_dropped",
                            "no part of the object is smaller than " + number(asked.drop_below_mm, 2) +
                                " mm, so none was left out: the smallest is " +
                                number(report.smallest_mm, 2) + " mm long",
                            {}});
    }
    if (asked.cut_plane && !report.plane_cut) {
        const auto& [x, y, z, distance] = *asked.cut_plane;
        findings.push_back({Severity::warning,
                            "cut_missed",
                            "the cutting plane meets nothing, so nothing was cut off: it lies " +
                                number(distance, 2) + " mm from the file's origin along " + number(x, 3) +
                                "," + number(y, 3) + "," + number(z, 3) + ", and the object lies from " +
                                number(report.nearest_mm, 2) + " to " + number(report.farthest_mm, 2) +
                                " mm; choose a distance between these",
                            {}});
    }
    if (!report.dropped.empty()) {
        double share = 0, longest = 0;
        for (const PartShare& part : report.dropped) {
            share += part.share;
            longest = std::max(longest, part.bounds.longest_side());
        }
        findings.push_back({Severity::note,
                            "dropped",
                            counted(report.dropped.size(), "part was", "parts were") +
                                " left out, as asked: at most " + number(longest, 2) + " mm long, together " +
                                number(share * 100, 2) + " % of the surface",
                            {}});
    }
    if (report.plane_cut)
        findings.push_back({Severity::note,
                            "cut_off",
                            "what lay behind the cutting plane was left out, as asked, and the cut closed",
                            {}});
}

}  // namespace snug
