#include "snug/design/known_foams.h"

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

#include "snug/base/text.h"
#include "snug/design/cushion_points.h"
#include "snug/design/json_reader.h"
#include "snug/design/option_json.h"
#include "snug/design/presets.h"
#include "snug/words/catalogue.h"

namespace snug {
namespace {

constexpr const char* kDesignGuide = "Ethafoam Package Design Guide, step 4";

/// Of which the maker says only what it bears for long.
FoamMaterial creep_alone(const char* name, const Message& title, double creep_kpa,
                         std::optional<double> density = {}) {
    FoamMaterial foam;
    foam.name = name;
    foam.title = text(title);
    foam.density_kg_m3 = density;
    foam.creep_kpa = creep_kpa;
    foam.status = FoamStatus::makers_sheet;
    foam.source = kDesignGuide;
    return foam;
}

FoamMaterial ld33() {
    FoamMaterial foam;
    foam.name = "ld33";
    foam.title = text(say("foam/ld33"));
    foam.curve = {{0.25, 40}, {0.4, 75}, {0.5, 115}, {0.6, 175}};
    foam.density_kg_m3 = 33;
    foam.status = FoamStatus::makers_sheet;
    foam.source = "Plastazote LD33 data sheet, customfoams.co.uk";
    return foam;
}

/// The one cushion curve that could be read in full: 36 lb from 24 in on 2 in, 40 G from 0.4 to 1.2 psi. It
/// sets the plateau of the closed-cell law and says nothing more.
FoamMaterial ethafoam_200lc() {
    constexpr double kPlateau = 70, kSolid = 0.04, kLast = 0.75;
    FoamMaterial foam;
    foam.name = "ethafoam-200lc";
    foam.title = text(say("foam/ethafoam-200lc"));
    foam.curve = closed_cell_points(kPlateau, kSolid, kLast);
    foam.thickness_mm = Vec2d{50.8, 50.8};
    foam.status = FoamStatus::model;
    foam.source =
        "closed-cell gas law, plateau set by one example: repco.com, How to use dynamic cushion curves";
    return foam;
}

/// "points": [[kPa, G, mm, mm], ...]
Result<std::vector<CushionPoint>> points_from(const nlohmann::json& json) {
    std::vector<CushionPoint> points;
    const auto wrong = [] { return fail(ErrorKind::usage, say("cushion.points")); };
    if (!json.is_array()) return wrong();
    for (const nlohmann::json& each : json) {
        if (!each.is_array() || each.size() != 4) return wrong();
        for (const nlohmann::json& number : each)
            if (!number.is_number()) return wrong();
        points.push_back(
            {each[0].get<double>(), each[1].get<double>(), each[2].get<double>(), each[3].get<double>()});
    }
    return points;
}

/// Takes the points out of the entry and puts the curve that they make into the foam.
Result<void> fit_points(nlohmann::json& entry, FoamMaterial& foam) {
    const auto points = points_from(entry["points"]);
    if (!points) return tl::unexpected(points.error());
    auto fit = fit_cushion_points(*points);
    if (!fit) return tl::unexpected(fit.error());
    entry.erase("points");
    foam.curve = std::move(fit->curve);
    foam.thickness_mm = Vec2d{fit->least_mm, fit->greatest_mm};
    foam.impacts = 1;
    foam.status = FoamStatus::measured;
    return {};
}

Result<FoamMaterial> foam_from(nlohmann::json entry, const std::string& path) {
    const auto refuse = [&](const Message& what) { return fail(ErrorKind::usage, in_file(path, what)); };
    if (!entry.is_object()) return fail(ErrorKind::usage, not_an_object(path));
    if (!entry.contains("name") || entry["name"] == "")
        return fail(ErrorKind::usage, must_be(path + ".name", say("json.word")));
    if (entry.contains("points") == entry.contains("curve") && entry.contains("points"))
        return refuse(say("foam.curve_or_points"));
    FoamMaterial foam;
    if (entry.contains("points"))
        if (auto done = fit_points(entry, foam); !done) return refuse(done.error().message);
    OptionList list;
    visit_options(list, foam);
    if (auto problem = read_options(entry, list, path + ".")) return fail(ErrorKind::usage, *problem);
    if (entry.contains("curve") && foam.curve.empty()) return refuse(say("curve.two_points"));
    // Every curve begins there, whether it is written or not.
    if (!foam.curve.empty() && foam.curve.front() == StressPoint{}) foam.curve.erase(foam.curve.begin());
    if (auto problem = problem_of(foam)) return refuse(problem->message);
    return foam;
}

}  // namespace

const std::vector<FoamMaterial>& built_in_foams() {
    static const std::vector<FoamMaterial> foams{
        ld33(),
        ethafoam_200lc(),
        creep_alone("ethafoam-220", say("foam/ethafoam-220"), 17.2, 35),
        creep_alone("ethafoam-nova", say("foam/ethafoam-nova"), 10.3),
        creep_alone("ethafoam-select", say("foam/ethafoam-select"), 13.8),
        creep_alone("ethafoam-hs-45", say("foam/ethafoam-hs-45"), 34.5),
        creep_alone("ethafoam-hs-600", say("foam/ethafoam-hs-600"), 68.9)};
    return foams;
}

std::string title_of(const FoamMaterial& foam, Language language) {
    const std::string code = "foam/" + foam.name;
    return wording(code) && text(say(code)) == foam.title ? text(say(code), language) : foam.title;
}

Result<std::vector<FoamMaterial>> parse_foams(std::string_view text) {
    const auto json = parse_json(text, ErrorKind::usage);
    if (!json) return tl::unexpected(json.error());
    if (!json->is_array())
        return fail(ErrorKind::usage, say("preset.no_list", {{"example", "[{...}, {...}]"}}));
    std::vector<FoamMaterial> foams;
    for (std::size_t i = 0; i < json->size(); ++i) {
        auto foam = foam_from((*json)[i], "foam " + std::to_string(i + 1));
        if (!foam) return tl::unexpected(foam.error());
        if (std::any_of(foams.begin(), foams.end(),
                        [&](const FoamMaterial& other) { return other.name == foam->name; }))
            return fail(ErrorKind::usage, say("foam.twice", {{"name", foam->name}}));
        foams.push_back(std::move(*foam));
    }
    return foams;
}

Result<FoamMaterial> find_foam(const std::vector<FoamMaterial>& known, std::string_view name) {
    const auto found = std::find_if(known.rbegin(), known.rend(),
                                    [&](const FoamMaterial& foam) { return foam.name == name; });
    if (found != known.rend()) return *found;
    std::vector<Message> names;
    for (const FoamMaterial& foam : known) names.push_back(as_it_is(foam.name));
    return fail(ErrorKind::usage, say("foam.unknown", {{"name", quoted(name)}, {"known", names}}));
}

void apply(const FoamMaterial& foam, Design& design) {
    design.protection.foam = foam;
    design.fit.creep_kpa = foam.creep_kpa;
    // What is printed or built keeps its own, whatever foam its drops are told of.
    if (foam.density_kg_m3 && !is_rigid(design)) design.workshop.density_kg_m3 = foam.density_kg_m3;
}

}  // namespace snug
