#include "snug/design/project.h"

#include <algorithm>
#include <array>
#include <span>

#include "snug/base/text.h"
#include "snug/base/utf16.h"
#include "snug/design/fit_json.h"
#include "snug/design/json_reader.h"
#include "snug/design/workshop_json.h"

namespace snug {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;

template <class T>
Json array(Vec3<T> v) {
    return Json::array({v.x, v.y, v.z});
}

template <class T>
Json value_or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// One number where the six walls are equal, as older projects have it.
Json wall_or_null(const std::optional<Walls>& walls) {
    if (!walls) return nullptr;
    return are_equal(*walls) ? Json(walls->front()) : Json(*walls);
}

Json section_or_null(const std::optional<CrossSection>& section) {
    return section ? Json::array({section->width, section->length}) : Json(nullptr);
}

Json case_json(const CaseOptions& options) {
    return {{"name", options.name},
            {"inside_mm", options.inside_mm ? array(*options.inside_mm) : Json(nullptr)},
            {"play_mm", options.play_mm},
            {"lid_mm", value_or_null(options.lid_mm)},
            {"corner_radius_mm", options.corner_radius_mm},
            {"base_mm", section_or_null(options.base_mm)},
            {"top_mm", section_or_null(options.top_mm)},
            {"divisor", value_or_null(options.divisor)},
            {"division", division_name(options.division)}};
}

Json search_json(const SearchOptions& search) {
    Json weights = Json::object();
    for (std::size_t i = 0; i < kObjectives; ++i)
        weights[std::string(objective_name(static_cast<Objective>(i)))] = search.weight[i];
    return {{"weights", weights},
            {"upright", search.upright ? Json(std::string(upright_name(*search.upright))) : Json(nullptr)},
            {"case", std::string(case_goal_name(search.case_goal))},
            {"billed_divisor", search.billed_divisor},
            {"seed", static_cast<int>(search.seed)}};
}

Json clean_json(const CleanOptions& clean) {
    return {{"drop_parts", clean.drop_parts},
            {"drop_below_mm", clean.drop_below_mm},
            {"cut_plane", clean.cut_plane ? Json(*clean.cut_plane) : Json(nullptr)}};
}

void read_clean(JsonReader json, CleanOptions& clean, JsonReader& parent) {
    json.read("drop_parts", clean.drop_parts)
        .read("drop_below_mm", clean.drop_below_mm)
        .read_list("cut_plane", clean.cut_plane, "four numbers in brackets, or null");
    parent.adopt(json);
}

Json to_json(const Design& design) {
    const ObjectOptions& object = design.object;
    const SpaceOptions& space = design.space;
    Json json;
    json["object"] = {{"units", object.units ? Json(std::string(unit_name(*object.units))) : Json(nullptr)},
                      {"scale", object.scale},
                      {"longest_mm", value_or_null(object.longest_mm)},
                      {"cap", object.cap},
                      {"point_radius_mm", object.point_radius_mm},
                      {"clean", clean_json(object.clean)}};
    json["space"] = {{"preset", space.preset},
                     {"blocks", space.blocks ? array(*space.blocks) : Json("auto")},
                     {"block_mm", array(space.block_mm)},
                     {"wall_mm", wall_or_null(space.wall_mm)}};
    json["placement"] = {{"rotation_deg", array(design.placement.rotation_deg)},
                         {"offset_mm", array(design.placement.offset_mm)}};
    json["cut"] = {{"clearance_mm", clearance_json(design.cut.clearance_mm)},
                   {"liner_mm", design.cut.liner_mm},
                   {"cut_on_touch", design.cut.cut_on_touch}};
    json["fit"] = fit_json(design.fit);
    json["parting"] = {{"level", design.parting.level ? Json(*design.parting.level) : Json("auto")}};
    json["output"] = {{"formats", design.output.formats}};
    json["case"] = case_json(design.case_options);
    json["search"] = search_json(design.search);
    json["workshop"] = workshop_json(design.workshop);
    return json;
}

void read_object(JsonReader json, ObjectOptions& object, JsonReader& parent) {
    std::optional<std::string> units;
    json.read("units", units)
        .read("scale", object.scale)
        .read("longest_mm", object.longest_mm)
        .read("cap", object.cap)
        .read("point_radius_mm", object.point_radius_mm);
    read_clean(json.object("clean"), object.clean, json);
    object.units = units ? unit_from_name(*units) : std::nullopt;
    if (units && !object.units) json.refuse("units", "mm, cm, m, in or null");
    parent.adopt(json);
}

/// A field that holds either the word auto (then `target` is none) or a value.
template <class T>
void read_or_auto(JsonReader& json, const char* name, std::optional<T>& target) {
    std::string word;
    JsonReader as_word = json;
    if (json.has(name) && (as_word.read(name, word), word == "auto")) {
        target.reset();
        json.read(name, word);
        return;
    }
    T value = target.value_or(T{});
    if (json.has(name)) {
        json.read(name, value);
        target = value;
    }
}

void read_space(JsonReader json, SpaceOptions& space, JsonReader& parent) {
    json.read("preset", space.preset).read("block_mm", space.block_mm);
    json.read_list("wall_mm", space.wall_mm, "a number, six numbers in brackets, or null", true);
    read_or_auto(json, "blocks", space.blocks);
    parent.adopt(json);
}

void read_placement(JsonReader json, PlacementOptions& placement, JsonReader& parent) {
    json.read("rotation_deg", placement.rotation_deg).read("offset_mm", placement.offset_mm);
    parent.adopt(json);
}

void read_cut(JsonReader json, CutOptions& cut, JsonReader& parent) {
    read_clearance(json, "clearance_mm", cut.clearance_mm);
    json.read("liner_mm", cut.liner_mm).read("cut_on_touch", cut.cut_on_touch);
    parent.adopt(json);
}

void read_parting(JsonReader json, PartingOptions& parting, JsonReader& parent) {
    read_or_auto(json, "level", parting.level);
    parent.adopt(json);
}

void read_output(JsonReader json, OutputOptions& output, JsonReader& parent) {
    json.read("formats", output.formats);
    parent.adopt(json);
}

void read_section(JsonReader& json, const char* name, std::optional<CrossSection>& section) {
    std::optional<std::array<double, 2>> sides;
    if (section) sides = {section->width, section->length};
    json.read_list(name, sides, "two numbers in brackets (width, length), or null");
    section.reset();
    if (sides) section = CrossSection{(*sides)[0], (*sides)[1]};
}

void read_case(JsonReader json, CaseOptions& options, JsonReader& parent) {
    std::string division(division_name(options.division));
    json.read("name", options.name)
        .read("inside_mm", options.inside_mm)
        .read("play_mm", options.play_mm)
        .read("lid_mm", options.lid_mm)
        .read("corner_radius_mm", options.corner_radius_mm)
        .read("divisor", options.divisor)
        .read("division", division);
    read_section(json, "base_mm", options.base_mm);
    read_section(json, "top_mm", options.top_mm);
    if (const auto known = division_from_name(division))
        options.division = *known;
    else
        json.refuse("division", "none, across or all");
    parent.adopt(json);
}

void read_search(JsonReader json, SearchOptions& search, JsonReader& parent) {
    JsonReader weights = json.object("weights");
    for (std::size_t i = 0; i < kObjectives; ++i)
        weights.read(std::string(objective_name(static_cast<Objective>(i))).c_str(), search.weight[i]);
    json.adopt(weights);
    std::optional<std::string> upright;
    std::string goal(case_goal_name(search.case_goal));
    int seed = static_cast<int>(search.seed);
    json.read("upright", upright)
        .read("case", goal)
        .read("billed_divisor", search.billed_divisor)
        .read("seed", seed);
    search.upright = upright ? upright_from_name(*upright) : std::nullopt;
    if (upright && !search.upright) json.refuse("upright", "x, y, z, -x, -y, -z or null");
    if (const auto known = case_goal_from_name(goal))
        search.case_goal = *known;
    else
        json.refuse("case", "volume or billed-weight");
    if (seed < 0) json.refuse("seed", "0 to 2147483647");
    search.seed = static_cast<std::uint32_t>(seed);
    parent.adopt(json);
}

Result<Design> design_from(JsonReader json) {
    Design design;
    read_object(json.object("object"), design.object, json);
    read_space(json.object("space"), design.space, json);
    read_placement(json.object("placement"), design.placement, json);
    read_cut(json.object("cut"), design.cut, json);
    read_fit(json.object("fit"), design.fit, json);
    read_parting(json.object("parting"), design.parting, json);
    read_output(json.object("output"), design.output, json);
    read_case(json.object("case"), design.case_options, json);
    read_search(json.object("search"), design.search, json);
    read_workshop(json.object("workshop"), design.workshop, json);
    if (const auto problem = json.problem()) return fail(ErrorKind::input, *problem);
    auto result = checked(design);
    if (!result) return fail(ErrorKind::input, result.error().message);
    return result;
}

bool is_sha256(const std::string& text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string design_json(const Design& design) {
    return text_of(to_json(design));
}

Result<Design> parse_design(std::string_view text) {
    const auto json = parse_json(text, ErrorKind::input);
    if (!json) return tl::unexpected(json.error());
    return design_from(JsonReader(*json, ""));
}

std::string project_json(const Project& project) {
    Json json;
    json["snug"] = kVersion;
    json["object"] = {
        {"name", project.object.name}, {"bytes", project.object.bytes}, {"sha256", project.object.sha256}};
    json["design"] = to_json(project.design);
    return text_of(json);
}

Result<Project> parse_project(std::string_view text) {
    const auto decoded = utf8_of_utf16(std::as_bytes(std::span(text.data(), text.size())));
    if (decoded) text = *decoded;
    const auto json = parse_json(text, ErrorKind::input);
    if (!json) return tl::unexpected(json.error());
    JsonReader reader(*json, "");
    int version = 0;
    reader.require("snug");
    reader.read("snug", version);
    if (version > kVersion)
        return fail(ErrorKind::input, "the project is of version " + std::to_string(version) +
                                          ", newer than this Snug understands (1): update Snug");
    if (version < 1) reader.refuse("snug", "the version number 1");

    Project project;
    reader.require("object");
    reader.require("design");
    JsonReader object = reader.object("object");
    object.read("name", project.object.name)
        .read("bytes", project.object.bytes)
        .read("sha256", project.object.sha256);
    object.require("name");
    const bool has_folder = project.object.name.find_first_of("/\\") != std::string::npos;
    if (project.object.name.empty() || has_folder || project.object.name == "..")
        object.refuse("name", "a file name without folders");
    if (!project.object.sha256.empty() && !is_sha256(project.object.sha256))
        object.refuse("sha256", "64 hexadecimal digits");
    reader.adopt(object);

    JsonReader design_reader = reader.object("design");
    if (const auto problem = reader.problem()) return fail(ErrorKind::input, *problem);
    auto design = design_from(std::move(design_reader));
    if (!design) return tl::unexpected(design.error());
    project.design = std::move(*design);
    return project;
}

}  // namespace snug
