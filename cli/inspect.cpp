#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "snug/base/one_line.h"
#include "snug/base/text.h"
#include "snug/design/design.h"
#include "snug/mesh/clean.h"
#include "snug/mesh/measure.h"
#include "snug/object/read_findings.h"
#include "snug/words/words.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/files.h"
#include "cli/scene_file.h"

namespace snug::cli {
namespace {

constexpr std::array<Unit, 4> kUnits{Unit::mm, Unit::cm, Unit::m, Unit::in};
constexpr std::size_t kPartsShown = 20;

struct InspectArguments {
    std::string object;
    bool json = false;
};

/// What people ship is mostly between a matchbox and a table; a unit that gives another size is unlikely.
bool likely(double longest_mm) {
    return longest_mm >= 30 && longest_mm <= 1500;
}

/// The unit that the file is most probably in: mm if that is likely, else the first likely one.
const Unit* likely_unit(double longest) {
    for (const Unit& unit : kUnits)
        if (likely(longest * millimetres(unit))) return &unit;
    return nullptr;
}

std::string size_lines(Vec3d size, bool in_mm) {
    if (in_mm) return fmt::format("Size        {} mm; the file states its unit\n", dimensions(size, 2));
    const double longest = std::max({size.x, size.y, size.z});
    const Unit* best = likely_unit(longest);
    std::string text = "Size, if the file is in\n";
    for (const Unit& unit : kUnits)
        text += fmt::format("  {:<4}{} mm{}\n", name_of(unit), dimensions(size * millimetres(unit), 2),
                            &unit == best ? "   <- likely" : "");
    return text;
}

std::string volume_lines(const std::optional<double>& volume, bool in_mm) {
    if (!volume) return "Volume      unknown: the surface is not closed\n";
    if (in_mm) return fmt::format("Volume      {} litres\n", number(*volume * 1e-6, 4));
    std::string text = "Volume, if the file is in\n";
    for (const Unit unit : kUnits) {
        const double mm = millimetres(unit);
        text += fmt::format("  {:<4}{} litres\n", name_of(unit), number(*volume * mm * mm * mm * 1e-6, 4));
    }
    return text;
}

std::vector<Finding> findings_of(const Mesh& mesh) {
    std::vector<Finding> findings;
    find_read_notes(mesh.read, mesh.vertices.size(), {}, findings);
    sort_by_severity(findings);
    return findings;
}

std::string finding_lines(const Mesh& mesh) {
    std::string text;
    for (const Finding& finding : findings_of(mesh))
        text +=
            fmt::format("{:<12}{}\n", severity_name(finding.severity), one_line(snug::text(finding.message)));
    return text;
}

/// The rest of the parts in one line.
std::string smaller_parts(const std::vector<PartShare>& shares) {
    double share = 0, longest = 0;
    for (std::size_t i = kPartsShown; i < shares.size(); ++i) {
        share += shares[i].share;
        longest = std::max(longest, shares[i].bounds.longest_side());
    }
    return fmt::format("  and {} more, at most {} long, {} % of the surface; --json lists all\n",
                       grouped(shares.size() - kPartsShown), number(longest, 3), number(share * 100, 2));
}

std::string described(const std::string& name, const Mesh& mesh, const MeshMeasure& measure) {
    const Vec3d size = measure.bounds.size();
    std::string text = fmt::format("{}\n", one_line(name));
    if (mesh.is_cloud())
        return text + fmt::format("A cloud of {}\n", counted(mesh.vertices.size(), "point", "points")) +
               size_lines(size, mesh.read.in_mm) + finding_lines(mesh);
    text += fmt::format("Triangles   {} with {}\n", grouped(mesh.triangles.size()),
                        counted(mesh.vertices.size(), "vertex", "vertices"));
    text += fmt::format("Holes       {}\n", measure.holes.empty() ? "none" : grouped(measure.holes.size()));
    text += fmt::format("Closed      {}\n", measure.watertight      ? "yes"
                                            : measure.holes.empty() ? "no: its triangles are wound both ways"
                                                                    : "no");
    text += fmt::format("Parts       {}\n", grouped(measure.parts.size()));
    if (measure.parts.size() > 1) {
        const std::vector<PartShare> shares = part_shares(mesh, measure);
        for (std::size_t i = 0; i < std::min(shares.size(), kPartsShown); ++i)
            text += fmt::format(
                "  {:<4}{} in {}, {}, {} % of the surface\n", shares[i].number,
                dimensions(shares[i].bounds.size(), 3), mesh.read.in_mm ? "mm" : "the file's unit",
                counted(shares[i].triangles, "triangle", "triangles"), number(shares[i].share * 100, 2));
        if (shares.size() > kPartsShown) text += smaller_parts(shares);
    }
    return text + size_lines(size, mesh.read.in_mm) + volume_lines(measure.volume, mesh.read.in_mm) +
           finding_lines(mesh);
}

std::string described_json(const std::string& name, const Mesh& mesh, const MeshMeasure& measure) {
    using Json = nlohmann::ordered_json;
    const Vec3d size = measure.bounds.size();
    const Unit* best = mesh.read.in_mm ? nullptr : likely_unit(std::max({size.x, size.y, size.z}));
    Json json{{"file", name},
              {"vertices", mesh.vertices.size()},
              {"triangles", mesh.triangles.size()},
              {"size", {size.x, size.y, size.z}},
              {"watertight", measure.watertight},
              {"holes", measure.holes.size()},
              {"volume", measure.volume ? Json(*measure.volume) : Json(nullptr)},
              {"likely_unit", best ? Json(std::string(name_of(*best))) : Json(nullptr)},
              {"stated_unit", mesh.read.in_mm ? Json("mm") : Json(nullptr)},
              {"left_out_faces", mesh.read.left_out_faces},
              {"left_out_points", mesh.read.left_out_points}};
    json["findings"] = Json::array();
    for (const Finding& finding : findings_of(mesh))
        json["findings"].push_back({{"severity", std::string(severity_name(finding.severity))},
                                    {"code", finding.code()},
                                    {"message", snug::text(finding.message)}});
    json["parts"] = Json::array();
    for (const PartShare& part : part_shares(mesh, measure)) {
        const Vec3d extent = part.bounds.size();
        json["parts"].push_back({{"triangles", part.triangles},
                                 {"size", {extent.x, extent.y, extent.z}},
                                 {"surface_share", part.share}});
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int inspect(const InspectArguments& arguments) {
    const auto bytes = read_file(arguments.object);
    if (!bytes) return report(bytes.error());
    const auto mesh = read_object(*bytes, arguments.object);
    if (!mesh) return report({mesh.error().kind, in_file(arguments.object, mesh.error().message)});
    const MeshMeasure measured = measure(*mesh);
    const auto done = print(arguments.json ? described_json(arguments.object, *mesh, measured)
                                           : described(arguments.object, *mesh, measured));
    return done ? kDone : report(done.error());
}

}  // namespace

CommandSpec inspect_command() {
    const auto a = std::make_shared<InspectArguments>();
    return {"inspect",
            "Tell size, holes, parts, volume and likely units",
            "Example: snug inspect scan.ply",
            {{"OBJECT", "", "A mesh (STL, OBJ, PLY, OFF, glTF, 3MF) or a point cloud (PLY, XYZ, PTS)",
              &a->object, true},
             {"--json", "", "Print it as JSON", &a->json}},
            [a] { return within_memory(a->object, [&] { return inspect(*a); }); }};
}

}  // namespace snug::cli
