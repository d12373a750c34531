#include "snug/design/project.h"

#include <algorithm>
#include <span>
#include <utility>

#include "snug/base/text.h"
#include "snug/base/utf16.h"
#include "snug/design/json_reader.h"
#include "snug/design/option_json.h"
#include "snug/words/words.h"

namespace snug {
namespace {

using OrderedJson = nlohmann::ordered_json;
constexpr int kVersion = 2;

OrderedJson to_json(const Design& design) {
    Design copy = design;
    return json_of(options_of(copy));
}

OrderedJson to_json(const ObjectOptions& options) {
    ObjectOptions copy = options;
    OptionList list;
    visit_options(list, copy);
    return json_of(list);
}

/// `prefix` stands before the path of what is wrong; without one, ranges are told without their path.
Result<Design> design_from(const nlohmann::json& json, const std::string& prefix) {
    Design design;
    if (const auto problem = read_options(json, design, prefix)) return fail(ErrorKind::input, *problem);
    auto result = checked(design);
    if (result) return result;
    const auto problem = problem_of(design);
    const Message& message = result.error().message;
    return fail(ErrorKind::input,
                problem && !prefix.empty() ? in_file(prefix + problem->path, message) : message);
}

bool is_sha256(const std::string& text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

ProjectObject object_from(JsonReader& reader) {
    ProjectObject object;
    ObjectFile& file = object.file;
    reader.read("name", file.name)
        .read("bytes", file.bytes)
        .read("sha256", file.sha256)
        .read("shape", file.shape);
    reader.require("name");
    const bool has_folder = file.name.find_first_of("/\\") != std::string::npos;
    if (file.name.empty() || has_folder || file.name == "..") reader.refuse("name", say("json.plain_name"));
    if (!file.sha256.empty() && !is_sha256(file.sha256)) reader.refuse("sha256", say("json.sha256"));
    (void)reader.object("options");
    return object;
}

/// An object's own choices, as they stand below `prefix`.
Result<ObjectOptions> own_options(const nlohmann::json& json, const std::string& prefix) {
    ObjectOptions own;
    OptionList list;
    visit_options(list, own);
    if (const auto problem = read_options(json, list, prefix)) return fail(ErrorKind::input, *problem);
    if (const auto found = problem_of(own))
        return fail(ErrorKind::input, in_file(prefix + found->path, found->message));
    return own;
}

/// Items are of objects that there are, and no object lies nowhere.
std::optional<Message> look_at_items(const Project& project) {
    const std::vector<ItemOptions>& items = project.design.items;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (static_cast<std::size_t>(items[i].object) >= project.objects.size())
            return must_be("design.items." + std::to_string(i) + ".object",
                           say("json.object_number", {{"last", std::to_string(project.objects.size() - 1)}}));
    for (std::size_t object = 0; object < project.objects.size(); ++object)
        if (std::none_of(items.begin(), items.end(), [&](const ItemOptions& item) {
                return static_cast<std::size_t>(item.object) == object;
            }))
            return must_be("objects." + std::to_string(object), say("json.lies_somewhere"));
    return {};
}

std::string text_of(const OrderedJson& json) {
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace

std::string design_json(const Design& design) {
    return text_of(to_json(design));
}

Result<Design> parse_design(std::string_view text) {
    const auto json = parse_json(text, ErrorKind::input);
    if (!json) return tl::unexpected(json.error());
    return design_from(*json, "");
}

Design design_for(const Project& project, std::size_t object) {
    Design design = project.design;
    if (project.objects[object].own) design.object = *project.objects[object].own;
    return design;
}

void take_over_one_item(Project& project) {
    Design& design = project.design;
    if (design.items.size() != 1) return;
    ItemOptions& item = design.items.front();
    const auto take = [](auto& own, auto& of_all) {
        if (own) of_all = *own;
        own.reset();
    };
    take(project.objects[static_cast<std::size_t>(item.object)].own, design.object);
    take(item.rotation_deg, design.placement.rotation_deg);
    take(item.offset_mm, design.placement.offset_mm);
    take(item.clearance_mm, design.cut.clearance_mm);
    take(item.mass_kg, design.workshop.mass_kg);
    take(item.centre_mm, design.protection.centre_mm);
    if (!item.zones.empty()) design.protection.zones = std::exchange(item.zones, {});
    if (item.fragility_g) design.protection.fragility.reset();
    take(item.fragility_g, design.protection.fragility_g);
}

std::string item_name(const Project& project, const ItemOptions& item) {
    const auto object = static_cast<std::size_t>(item.object);
    if (!item.name.empty() || object >= project.objects.size()) return item.name;
    return project.objects[object].file.name;
}

std::string names_of_items(const Project& project) {
    std::vector<std::pair<std::string, int>> counts;
    for (const ItemOptions& item : project.design.items) {
        const std::string name = item_name(project, item);
        const auto found =
            std::find_if(counts.begin(), counts.end(), [&](const auto& each) { return each.first == name; });
        if (found == counts.end())
            counts.emplace_back(name, 1);
        else
            ++found->second;
    }
    std::string names;
    for (const auto& [name, count] : counts)
        names += (names.empty() ? "" : ", ") + name + (count > 1 ? " x" + std::to_string(count) : "");
    return names;
}

std::string project_json(const Project& project) {
    OrderedJson json;
    json["snug"] = kVersion;
    for (const ProjectObject& object : project.objects) {
        OrderedJson one = {
            {"name", object.file.name}, {"bytes", object.file.bytes}, {"sha256", object.file.sha256}};
        if (!object.file.shape.empty()) one["shape"] = object.file.shape;
        if (object.own) one["options"] = to_json(*object.own);
        json["objects"].push_back(one);
    }
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
        return fail(ErrorKind::input, say("project.newer", {{"version", std::to_string(version)}}));
    if (version < 1) reader.refuse("snug", say("json.version"));

    Project project;
    const char* const objects = version < 2 ? "object" : "objects";
    reader.require(objects);
    reader.require("design");
    std::vector<JsonReader> each;
    if (version < 2)
        each.push_back(reader.object(objects));
    else
        each = reader.objects(objects, kMostItems);
    project.objects.clear();
    for (JsonReader& object : each) {
        project.objects.push_back(object_from(object));
        reader.adopt(object);
    }
    (void)reader.object("design");
    if (const auto problem = reader.problem()) return fail(ErrorKind::input, *problem);
    for (std::size_t i = 0; version > 1 && i < project.objects.size(); ++i) {
        const nlohmann::json& object = (*json)[objects][i];
        if (!object.contains("options")) continue;
        if (!object["options"].is_object())
            return fail(ErrorKind::input, not_an_object("objects." + std::to_string(i) + ".options"));
        auto own = own_options(object["options"], "objects." + std::to_string(i) + ".options.");
        if (!own) return tl::unexpected(own.error());
        project.objects[i].own = std::move(*own);
    }
    auto design = design_from((*json)["design"], "design.");
    if (!design) return tl::unexpected(design.error());
    project.design = std::move(*design);
    if (const auto problem = look_at_items(project)) return fail(ErrorKind::input, *problem);
    return project;
}

}  // namespace snug
