#include "snug/design/cases.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "snug/base/rotation.h"
#include "snug/base/text.h"
#include "snug/object/prepare.h"
#include "snug/search/rank_cases.h"
#include "snug/space/placement.h"
#include "snug/words/words.h"

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/files.h"
#include "cli/object_file.h"
#include "cli/option_values.h"
#include "cli/scene_file.h"
#include "cli/user_cases.h"
#include "cli/user_presets.h"

namespace snug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CasesArguments {
    std::optional<std::string> object, units, preset, wall, rotate;
    std::optional<double> mass, clearance, play;
    double divisor = 5000;
    bool json = false, csv = false;
};

Vec3d length_first(Vec3d size) {
    return {size.z, size.y, size.x};
}

std::string optional_text(const std::optional<double>& value, int decimals = 2) {
    return value ? number(*value, decimals) : std::string("-");
}

Json optional_json(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json list_of(Vec3d v) {
    const auto tidy = [](double value) { return std::floor(value * 1e6 + 0.5) / 1e6; };
    return Json::array({tidy(v.x), tidy(v.y), tidy(v.z)});
}

Json case_json(const KnownCase& known) {
    return {{"name", known.name},
            {"kind", known.kind},
            {"inside_mm", list_of(length_first(known.inside_mm))},
            {"lid_mm", optional_json(known.lid_mm)},
            {"tare_kg", optional_json(known.tare_kg)},
            {"price", optional_json(known.price)},
            {"most_kg", optional_json(known.most_kg)},
            {"carrier", known.carrier},
            {"divisor", optional_json(known.divisor)},
            {"source", known.source}};
}

std::string angles_text(Vec3d angles) {
    return number(angles.x, 6) + "," + number(angles.y, 6) + "," + number(angles.z, 6);
}

int list_cases(const std::vector<KnownCase>& cases, const CasesArguments& arguments) {
    std::string text;
    if (arguments.csv) {
        text = cases_csv(cases);
    } else if (arguments.json) {
        Json list = Json::array();
        for (const KnownCase& known : cases) list.push_back(case_json(known));
        text = list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    } else {
        text = fmt::format("{:<19}{:<14}{:<26}{:<8}{:<9}{:<9}{}\n", "name", "kind", "inside L x W x H, mm",
                           "lid mm", "most kg", "price", "carrier");
        for (const KnownCase& known : cases)
            text += fmt::format("{:<19}{:<14}{:<26}{:<8}{:<9}{:<9}{}\n", known.name, known.kind,
                                dimensions(length_first(known.inside_mm)), optional_text(known.lid_mm),
                                optional_text(known.most_kg), optional_text(known.price), known.carrier);
        text += fmt::format(
            "\nSizes differ between makers by some mm: measure yours. Add your own in {};\n"
            "`snug cases --csv` shows its columns, name and the three sizes are required.\n",
            user_cases_path().string());
    }
    const auto done = print(text);
    return done ? kDone : report(done.error());
}

std::string fitting_text(const CaseRanking& ranking, const Design& design) {
    std::string text = fmt::format("{:<19}{:<26}{:<7}{:<11}{:<9}{}\n", "name", "inside L x W x H, mm", "fill",
                                   "billed kg", "price", "lay it with");
    for (const RankedCase& ranked : ranking.fitting)
        text +=
            fmt::format("{:<19}{:<26}{:<7}{:<11}{:<9}--rotate={}\n", ranked.known.name,
                        dimensions(length_first(ranked.known.inside_mm)), number(ranked.fill * 100, 0) + " %",
                        optional_text(ranked.billed_kg, 0), optional_text(ranked.known.price),
                        angles_text(rotation_for(ranked.lay, design.placement.rotation_deg)));
    text += fmt::format(
        "\nBilled weight is the greater of mass and inside volume / divisor, in whole kg; a "
        "carrier measures outside.\nUse one with `snug make ... --case {}`.\n",
        ranking.fitting.front().known.name);
    return text;
}

/// What would do, and what is in the way of the nearest case.
Message nothing_fits(const CaseRanking& ranking) {
    constexpr const char* kLacking[3] = {"lacking.height", "lacking.width", "lacking.length"};
    std::vector<Message> nearest, too_weak;
    if (ranking.nearest) {
        std::vector<Message> lacking;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (const double mm = ranking.nearest->lacking_mm[axis]; mm > 0)
                lacking.push_back(say(kLacking[axis], {{"mm", number(std::ceil(mm * 10) / 10, 1)}}));
        nearest.push_back(
            say("cases.nearest", {{"name", ranking.nearest->known.name},
                                  {"inside", dimensions(length_first(ranking.nearest->known.inside_mm))},
                                  {"lacking", lacking}}));
    }
    for (const KnownCase& weak : ranking.too_weak)
        too_weak.push_back(say("cases.too_weak", {{"name", weak.name}, {"kg", number(*weak.most_kg)}}));
    return say("cases.nothing_fits", {{"least", dimensions(length_first(ranking.least_inside_mm))},
                                      {"nearest", nearest},
                                      {"too_weak", too_weak}});
}

Json ranking_json(const CaseRanking& ranking, const Design& design) {
    const auto entry = [&](const RankedCase& ranked) {
        Json json = case_json(ranked.known);
        json["fill"] = ranked.fill;
        json["billed_kg"] = optional_json(ranked.billed_kg);
        json["rotation_deg"] = list_of(rotation_for(ranked.lay, design.placement.rotation_deg));
        json["lacking_mm"] = list_of({ranked.lacking_mm[2], ranked.lacking_mm[1], ranked.lacking_mm[0]});
        return json;
    };
    Json json{{"least_inside_mm", list_of(length_first(ranking.least_inside_mm))},
              {"fitting", Json::array()}};
    for (const RankedCase& ranked : ranking.fitting) json["fitting"].push_back(entry(ranked));
    json["nearest"] = ranking.nearest ? entry(*ranking.nearest) : Json(nullptr);
    json["too_weak"] = Json::array();
    for (const KnownCase& weak : ranking.too_weak) json["too_weak"].push_back(weak.name);
    return json;
}

Result<Design> design_for(const CasesArguments& a, Design design, bool is_project) {
    if (a.preset) {
        const auto presets = known_presets();
        if (!presets) return tl::unexpected(presets.error());
        const auto preset = find_preset(*presets, *a.preset);
        if (!preset) return tl::unexpected(preset.error());
        apply(*preset, design);
    }
    if (a.units) {
        design.object.units = unit_from_name(*a.units);
        if (!design.object.units)
            return fail(ErrorKind::usage, fmt::format("--units takes mm, cm, m or in, not \"{}\"", *a.units));
    }
    if (a.rotate) {
        const auto angles = parse_vector("--rotate", *a.rotate);
        if (!angles) return tl::unexpected(angles.error());
        design.placement.rotation_deg = *angles;
    }
    if (a.clearance) design.cut.clearance_mm = *a.clearance;
    if (a.play) design.case_options.play_mm = *a.play;
    if (!is_project) design.space.wall_mm = equal_walls(50);
    if (a.wall) {
        const auto walls = parse_walls("--wall", *a.wall);
        if (!walls) return tl::unexpected(walls.error());
        design.space.wall_mm = *walls;
    }
    return checked(design);
}

int rank_for(const std::vector<KnownCase>& cases, const CasesArguments& arguments) {
    auto source = find_object(*arguments.object);
    if (!source) return report(source.error());
    const auto design = design_for(arguments, source->project ? source->project->design : Design{},
                                   source->project.has_value());
    if (!design) return report(design.error());
    const std::string path = source->object.string();
    const auto bytes = read_file(source->object);
    if (!bytes) return report(bytes.error());
    auto mesh = read_object(*bytes, path);
    if (!mesh) return report({mesh.error().kind, in_file(path, mesh.error().message)});
    if (const auto error = unwanted_units(*mesh, arguments.units.has_value()))
        return report({error->kind, in_file(path, error->message)});
    const auto object = prepare(std::move(*mesh), *design);
    if (!object) return report({object.error().kind, in_file(path, object.error().message)});
    const Placement placement = place(object->mesh, design->placement.rotation_deg, {});
    const Cargo cargo{placement.bounds.size(), arguments.mass, arguments.divisor};
    const CaseRanking ranking = rank_cases(cases, *design, cargo);
    if (arguments.json) {
        const Json json = ranking_json(ranking, *design);
        if (auto done = print(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); !done)
            return report(done.error());
    }
    if (ranking.fitting.empty())
        return report({ErrorKind::does_not_fit, in_file(path, nothing_fits(ranking))});
    if (arguments.json) return kDone;
    const auto done = print(fitting_text(ranking, *design));
    return done ? kDone : report(done.error());
}

int cases(const CasesArguments& arguments) {
    const auto known = known_cases();
    if (!known) return report(known.error());
    return arguments.object ? rank_for(*known, arguments) : list_cases(*known, arguments);
}

void add_options(CLI::App& command, CasesArguments& a) {
    CLI::Option* object =
        command.add_option("--for", a.object, "Only cases that fit this object (or project), best first")
            ->type_name("OBJECT|PROJECT");
    const auto add = [&](const char* name, auto& target, const char* text, const char* type) {
        return command.add_option(name, target, text)->type_name(type)->needs(object);
    };
    add("--mass", a.mass, "The object's mass", "KG")->check(CLI::Range(0.0, 1e6));
    add("--wall", a.wall, "Least foam on each side, as `snug make` takes it (50, or the project's)",
        "MM|X,Y,Z|SIX");
    add("--preset", a.preset, "The foam (paper, or the project's)", "NAME");
    add("--clearance", a.clearance, "Grow the object by this (0, or the preset's)", "MM");
    add("--rotate", a.rotate, "How the object lies (0,0,0); its axes are exchanged too", "PSI,THETA,PHI");
    add("--units", a.units, "The unit of the file (mm)", "mm|cm|m|in");
    add("--case-play", a.play, "Air between foam and case on each side (3)", "MM");
    add("--divisor", a.divisor, "cm3 for one kg of volumetric weight (5000)", "CM3")
        ->check(CLI::Range(1.0, 1e6));
    CLI::Option* json = command.add_flag("--json", a.json, "Print JSON instead of a table");
    command.add_flag("--csv", a.csv, "Print the list as CSV, to extend")->excludes(object)->excludes(json);
    command.footer("Examples:\n  snug cases\n  snug cases --for camera.stl --wall 25 --mass 1.2");
}

}  // namespace

void add_cases(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("cases", "List cartons and cases, or those that fit an object");
    const auto arguments = std::make_shared<CasesArguments>();
    add_options(*command, *arguments);
    command->callback([arguments, &chosen] { chosen = [arguments] { return cases(*arguments); }; });
}

}  // namespace snug::cli
