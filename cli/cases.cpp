#include "snug/design/cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "snug/base/rotation.h"
#include "snug/base/text.h"
#include "snug/object/prepare.h"
#include "snug/search/rank_cases.h"
#include "snug/space/placement.h"
#include "snug/words/words.h"

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/files.h"
#include "cli/object_file.h"
#include "cli/scene_file.h"
#include "cli/user_cases.h"
#include "cli/user_foams.h"
#include "cli/user_presets.h"
#include "cli/wrapped.h"

namespace snug::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CasesArguments {
    Language language;
    std::optional<std::string> object;
    std::vector<TypedFlag> typed;  ///< about the design
    std::optional<double> mass;
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
            {"maker", known.maker},
            {"divisor", optional_json(known.divisor)},
            {"source", known.source}};
}

std::string angles_text(Vec3d angles) {
    return number(angles.x, 6) + "," + number(angles.y, 6) + "," + number(angles.z, 6);
}

/// Cells below each other, each `widths` columns wide but the last.
template <std::size_t N>
std::string line(const std::array<std::size_t, N>& widths, const std::array<std::string, N + 1>& cells) {
    std::string text;
    for (std::size_t i = 0; i < N; ++i) text += padded(cells[i], widths[i]);
    return text + cells[N] + "\n";
}

/// "hard case"; a kind of a user's own as it was written.
std::string kind_of(const KnownCase& known, Language language) {
    if (known.kind == "carton") return text(say("kind.carton"), language);
    if (known.kind == "hard case") return text(say("kind.hard_case"), language);
    if (known.kind == "parcel class") return text(say("kind.parcel_class"), language);
    return known.kind;
}

std::string cases_text(const std::vector<KnownCase>& cases, Language language) {
    constexpr std::array<std::size_t, 6> kWidths{19, 14, 26, 8, 9, 9};
    const auto said = [&](const Message& message) { return snug::text(message, language); };
    std::string text =
        line(kWidths,
             {said(say("list.name")), said(say("list.kind")), said(say("list.inside")), said(say("list.lid")),
              said(say("list.most_kg")), said(say("list.price")), said(say("list.carrier"))});
    for (const KnownCase& known : cases)
        text +=
            line(kWidths, {known.name, kind_of(known, language), dimensions(length_first(known.inside_mm)),
                           optional_text(known.lid_mm), optional_text(known.most_kg),
                           optional_text(known.price), known.carrier.empty() ? known.maker : known.carrier});
    return text + "\n" + said(say("list.own_cases", {{"file", user_cases_path().string()}})) + "\n";
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
        text = cases_text(cases, arguments.language);
    }
    const auto done = print(text);
    return done ? kDone : report(done.error(), arguments.language);
}

std::string fitting_text(const CaseRanking& ranking, const Design& design, Language language) {
    constexpr std::array<std::size_t, 5> kWidths{19, 26, 7, 11, 9};
    const auto said = [&](const Message& message) { return snug::text(message, language); };
    std::string text =
        line(kWidths, {said(say("list.name")), said(say("list.inside")), said(say("list.fill")),
                       said(say("list.billed")), said(say("list.price")), said(say("list.lay"))});
    for (const RankedCase& ranked : ranking.fitting)
        text += line(kWidths,
                     {ranked.known.name, dimensions(length_first(ranked.known.inside_mm)),
                      number(ranked.fill * 100, 0) + " %", optional_text(ranked.billed_kg, 0),
                      optional_text(ranked.known.price),
                      "--rotate=" + angles_text(rotation_for(ranked.lay, design.placement.rotation_deg))});
    return text + "\n" + said(say("list.billed_weight", {{"name", ranking.fitting.front().known.name}})) +
           "\n";
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
    if (!is_project) design.space.wall_mm = equal_walls(50);
    const auto is_preset = [](const TypedFlag& typed) { return typed.flag == "--preset"; };
    const auto preset = std::find_if(a.typed.begin(), a.typed.end(), is_preset);
    if (preset != a.typed.end()) {
        auto result = with_flags({&*preset, 1}, std::move(design), true,
                                 {known_presets, [&] { return known_cases(a.language); }, known_foams});
        if (!result) return result;
        design = std::move(*result);
    }
    for (const TypedFlag& each : a.typed)
        if (!is_preset(each))
            if (auto done = take_flag(each, design); !done) return tl::unexpected(done.error());
    return checked(std::move(design));
}

int rank_for(const std::vector<KnownCase>& cases, const CasesArguments& arguments) {
    const Language language = arguments.language;
    auto source = find_object(*arguments.object);
    if (!source) return report(source.error(), language);
    const auto design = design_for(arguments, source->project ? source->project->design : Design{},
                                   source->project.has_value());
    if (!design) return report(design.error(), language);
    const std::string path = source->object.string();
    const auto bytes = read_file(source->object);
    if (!bytes) return report(bytes.error(), language);
    auto mesh = read_object(*bytes, path);
    if (!mesh) return report({mesh.error().kind, in_file(path, mesh.error().message)}, language);
    if (const auto error = unwanted_units(*mesh, was_typed(arguments.typed, "--units")))
        return report({error->kind, in_file(path, error->message)}, language);
    const auto object = prepare(std::move(*mesh), *design);
    if (!object) return report({object.error().kind, in_file(path, object.error().message)}, language);
    const Placement placement = place(object->mesh, design->placement.rotation_deg, {});
    const Cargo cargo{placement.bounds.size(), arguments.mass, arguments.divisor};
    const CaseRanking ranking = rank_cases(cases, *design, cargo);
    if (arguments.json) {
        const Json json = ranking_json(ranking, *design);
        if (auto done = print(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); !done)
            return report(done.error(), language);
    }
    if (ranking.fitting.empty())
        return report({ErrorKind::does_not_fit, in_file(path, nothing_fits(ranking))}, language);
    if (arguments.json) return kDone;
    const auto done = print(fitting_text(ranking, *design, language));
    return done ? kDone : report(done.error(), language);
}

int cases(const CasesArguments& arguments) {
    const auto known = known_cases(arguments.language);
    if (!known) return report(known.error(), arguments.language);
    return arguments.object ? rank_for(*known, arguments) : list_cases(*known, arguments);
}

/// Flags of `snug make`, with what they mean here.
Argument of_the_design(CasesArguments& a, const char* name, const char* takes, Message help) {
    return {name, takes, text(help, a.language), DesignFlag{&a.typed}, false, {}, {"--for"}};
}

}  // namespace

CommandSpec cases_command(Language language) {
    const auto a = std::make_shared<CasesArguments>();
    a->language = language;
    const auto help = [&](const Message& message) { return text(message, language); };
    return {"cases",
            help(say("help.cases")),
            "\n  snug cases\n  snug cases --for camera.stl --wall 25 --mass 1.2",
            {{"--for", "OBJECT|PROJECT", help(say("help.cases.for")), &a->object},
             {"--mass", "KG", help(say("help.cases.mass")), &a->mass, false, {{0, 1e6}}, {"--for"}},
             of_the_design(*a, "--wall", "MM|X,Y,Z|SIX", say("help.cases.wall")),
             of_the_design(*a, "--preset", "NAME", say("help.cases.preset")),
             of_the_design(*a, "--clearance", "MM|X,Y,Z|SIX", say("help.cases.clearance")),
             of_the_design(*a, "--rotate", "PSI,THETA,PHI", say("help.cases.rotate")),
             of_the_design(*a, "--units", "mm|cm|m|in", say("help.cases.units")),
             of_the_design(*a, "--case-play", "MM", say("help.cases.play")),
             {"--divisor", "CM3", help(say("help.cases.divisor")), &a->divisor, false, {{1, 1e6}}, {"--for"}},
             {"--json", "", help(say("help.cases.json")), &a->json},
             {"--csv", "", help(say("help.cases.csv")), &a->csv, false, {}, {}, {"--for", "--json"}}},
            [a] { return cases(*a); }};
}

}  // namespace snug::cli
