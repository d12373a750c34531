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
            return fail(ErrorKind::usage,
                        say("clean.no_part", {{"number", std::to_string(number)}, {"parts", parts}}));
        drop[static_cast<std::size_t>(number) - 1] = true;
    }
    for (std::size_t p = 0; p < parts; ++p)
        if (measured.parts[p].bounds.longest_side() < options.drop_below_mm) drop[p] = true;
    if (std::find(drop.begin(), drop.end(), false) == drop.end())
        return fail(ErrorKind::usage, say("clean.nothing_left"));
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
        if (result.mesh.is_cloud()) return fail(ErrorKind::usage, say("clean.cloud"));
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
    if (rest.vertices.empty()) return fail(ErrorKind::usage, say("clean.all_behind"));
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
        findings.push_back(
            {Severity::note, say("nothing_dropped", {{"below", number(asked.drop_below_mm, 2)},
                                                     {"smallest", number(report.smallest_mm, 2)}})});
    }
    if (asked.cut_plane && !report.plane_cut) {
        const auto& [x, y, z, distance] = *asked.cut_plane;
        findings.push_back(
            {Severity::warning,
             say("cut_missed", {{"distance", number(distance, 2)},
                                {"direction", number(x, 3) + "," + number(y, 3) + "," + number(z, 3)},
                                {"nearest", number(report.nearest_mm, 2)},
                                {"farthest", number(report.farthest_mm, 2)}})});
    }
    if (!report.dropped.empty()) {
        double share = 0, longest = 0;
        for (const PartShare& part : report.dropped) {
            share += part.share;
            longest = std::max(longest, part.bounds.longest_side());
        }
        findings.push_back({Severity::note, say("dropped", {{"parts", report.dropped.size()},
                                                            {"longest", number(longest, 2)},
                                                            {"percent", number(share * 100, 2)}})});
    }
    if (report.plane_cut) findings.push_back({Severity::note, say("cut_off")});
}

}  // namespace snug
