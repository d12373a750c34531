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
#include "cli/wrapped.h"

namespace snug::cli {
namespace {

constexpr std::array<Unit, 4> kUnits{Unit::mm, Unit::cm, Unit::m, Unit::in};
constexpr std::size_t kPartsShown = 20;

struct InspectArguments {
    Language language;
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

constexpr std::size_t kLabel = 12;  // columns

/// Lines of text in a language.
struct Lines {
    Language language;
    std::string text = {};

    [[nodiscard]] std::string said(const Message& message) const { return snug::text(message, language); }
    void add(const Message& label, const Message& message) {
        text += padded(said(label), kLabel) + said(message) + "\n";
    }
    void add_heading(const Message& message) { text += said(message) + "\n"; }
    /// Below a heading, behind a short word.
    void add_below(std::string_view word, const std::string& rest) {
        text += fmt::format("  {:<4}{}\n", word, rest);
    }
};

void add_size(Vec3d size, bool in_mm, Lines& lines) {
    if (in_mm)
        return lines.add(say("inspect.size"), say("inspect.size_stated", {{"size", dimensions(size, 2)}}));
    const Unit* best = likely_unit(std::max({size.x, size.y, size.z}));
    lines.add_heading(say("inspect.size_if"));
    for (const Unit& unit : kUnits)
        lines.add_below(name_of(unit),
                        dimensions(size * millimetres(unit), 2) + " mm" +
                            (&unit == best ? lines.said(say("inspect.likely")) : std::string()));
}

void add_volume(const std::optional<double>& volume, bool in_mm, Lines& lines) {
    const auto litres = [](double mm3) { return say("figure.litres", {{"litres", number(mm3 * 1e-6, 4)}}); };
    if (!volume) return lines.add(say("inspect.volume"), say("inspect.no_volume"));
    if (in_mm) return lines.add(say("inspect.volume"), litres(*volume));
    lines.add_heading(say("inspect.volume_if"));
    for (const Unit unit : kUnits) {
        const double mm = millimetres(unit);
        lines.add_below(name_of(unit), lines.said(litres(*volume * mm * mm * mm)));
    }
}

std::vector<Finding> findings_of(const Mesh& mesh) {
    std::vector<Finding> findings;
    find_read_notes(mesh.read, mesh.vertices.size(), {}, findings);
    sort_by_severity(findings);
    return findings;
}

void add_findings(const Mesh& mesh, Lines& lines) {
    for (const Finding& finding : findings_of(mesh))
        lines.add(say(finding.severity == Severity::danger    ? "inspect.danger"
                      : finding.severity == Severity::warning ? "inspect.warning"
                                                              : "inspect.note"),
                  as_it_is(one_line(lines.said(finding.message))));
}

/// The rest of the parts in one line.
Message smaller_parts(const std::vector<PartShare>& shares) {
    double share = 0, longest = 0;
    for (std::size_t i = kPartsShown; i < shares.size(); ++i) {
        share += shares[i].share;
        longest = std::max(longest, shares[i].bounds.longest_side());
    }
    return say("inspect.smaller_parts", {{"parts", shares.size() - kPartsShown},
                                         {"longest", number(longest, 3)},
                                         {"percent", number(share * 100, 2)}});
}

void add_parts(const Mesh& mesh, const MeshMeasure& measure, Lines& lines) {
    lines.add(say("inspect.parts"), as_it_is(grouped(measure.parts.size())));
    if (measure.parts.size() < 2) return;
    const Message unit = mesh.read.in_mm ? as_it_is("mm") : say("inspect.file_unit");
    const std::vector<PartShare> shares = part_shares(mesh, measure);
    for (std::size_t i = 0; i < std::min(shares.size(), kPartsShown); ++i)
        lines.add_below(std::to_string(shares[i].number),
                        lines.said(say("inspect.part", {{"size", dimensions(shares[i].bounds.size(), 3)},
                                                        {"unit", unit},
                                                        {"triangles", shares[i].triangles},
                                                        {"percent", number(shares[i].share * 100, 2)}})));
    if (shares.size() > kPartsShown) lines.text += "  " + lines.said(smaller_parts(shares)) + "\n";
}

/// Where it lies in its file: where zones are kept off.
Message reach_of(const Mesh& mesh, const Box3d& bounds) {
    const auto place = [&](Vec3d p) {
        p = p + mesh.origin;
        return number(p.x, 3) + ", " + number(p.y, 3) + ", " + number(p.z, 3);
    };
    return say("inspect.from_to", {{"from", place(bounds.min)},
                                   {"to", place(bounds.max)},
                                   {"unit", mesh.read.in_mm ? as_it_is("mm") : say("inspect.file_unit")}});
}

std::string described(const std::string& name, const Mesh& mesh, const MeshMeasure& measure,
                      Language language) {
    Lines lines{language};
    lines.add_heading(as_it_is(one_line(name)));
    if (mesh.is_cloud()) {
        lines.add_heading(say("inspect.cloud", {{"points", mesh.vertices.size()}}));
    } else {
        lines.add(say("inspect.triangles"),
                  say("inspect.triangles_of",
                      {{"triangles", mesh.triangles.size()}, {"vertices", mesh.vertices.size()}}));
        lines.add(say("inspect.holes"),
                  measure.holes.empty() ? say("figure.none") : as_it_is(grouped(measure.holes.size())));
        lines.add(say("inspect.closed"), say(measure.watertight      ? "inspect.yes"
                                             : measure.holes.empty() ? "inspect.wound"
                                                                     : "inspect.no"));
        add_parts(mesh, measure, lines);
    }
    lines.add(say("inspect.reaches"), reach_of(mesh, measure.bounds));
    add_size(measure.bounds.size(), mesh.read.in_mm, lines);
    if (!mesh.is_cloud()) add_volume(measure.volume, mesh.read.in_mm, lines);
    add_findings(mesh, lines);
    return lines.text;
}

std::string described_json(const std::string& name, const Mesh& mesh, const MeshMeasure& measure,
                           Language language) {
    const Vec3d size = measure.bounds.size(), low = measure.bounds.min + mesh.origin;
    const Unit* best = mesh.read.in_mm ? nullptr : likely_unit(std::max({size.x, size.y, size.z}));
    using Described = nlohmann::ordered_json;
    Described json{{"file", name},
                   {"vertices", mesh.vertices.size()},
                   {"triangles", mesh.triangles.size()},
                   {"size", {size.x, size.y, size.z}},
                   {"from", {low.x, low.y, low.z}},
                   {"watertight", measure.watertight},
                   {"holes", measure.holes.size()},
                   {"volume", measure.volume ? Described(*measure.volume) : Described(nullptr)},
                   {"likely_unit", best ? Described(std::string(name_of(*best))) : Described(nullptr)},
                   {"stated_unit", mesh.read.in_mm ? Described("mm") : Described(nullptr)},
                   {"left_out_faces", mesh.read.left_out_faces},
                   {"left_out_points", mesh.read.left_out_points}};
    json["findings"] = Described::array();
    for (const Finding& finding : findings_of(mesh))
        json["findings"].push_back({{"severity", std::string(severity_name(finding.severity))},
                                    {"code", finding.code()},
                                    {"message", snug::text(finding.message, language)}});
    json["parts"] = Described::array();
    for (const PartShare& part : part_shares(mesh, measure)) {
        const Vec3d extent = part.bounds.size();
        json["parts"].push_back({{"triangles", part.triangles},
                                 {"size", {extent.x, extent.y, extent.z}},
                                 {"surface_share", part.share}});
    }
    return json.dump(2, ' ', false, Described::error_handler_t::replace) + "\n";
}

int inspect(const InspectArguments& arguments) {
    const Language language = arguments.language;
    const auto bytes = read_file(arguments.object);
    if (!bytes) return report(bytes.error(), language);
    const auto mesh = read_object(*bytes, arguments.object);
    if (!mesh) return report({mesh.error().kind, in_file(arguments.object, mesh.error().message)}, language);
    const MeshMeasure measured = measure(*mesh);
    const auto done = print(arguments.json ? described_json(arguments.object, *mesh, measured, language)
                                           : described(arguments.object, *mesh, measured, language));
    return done ? kDone : report(done.error(), language);
}

}  // namespace

CommandSpec inspect_command(Language language) {
    const auto a = std::make_shared<InspectArguments>();
    a->language = language;
    return {"inspect",
            text(say("help.inspect"), language),
            "snug inspect scan.ply",
            {{"OBJECT", "", text(say("help.inspect.object"), language), &a->object, true},
             {"--json", "", text(say("help.inspect.json"), language), &a->json}},
            [a] { return within_memory(a->object, a->language, [&] { return inspect(*a); }); }};
}

}  // namespace snug::cli
