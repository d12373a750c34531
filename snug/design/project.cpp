#include "snug/design/project.h"

#include <span>

#include "snug/base/text.h"
#include "snug/base/utf16.h"
#include "snug/design/json_reader.h"
#include "snug/design/option_json.h"
#include "snug/words/words.h"

namespace snug {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;

Json to_json(const Design& design) {
    Design copy = design;
    return json_of(options_of(copy));
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
    return design_from(*json, "");
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
        return fail(ErrorKind::input, say("project.newer", {{"version", std::to_string(version)}}));
    if (version < 1) reader.refuse("snug", say("json.version_1"));

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
        object.refuse("name", say("json.plain_name"));
    if (!project.object.sha256.empty() && !is_sha256(project.object.sha256))
        object.refuse("sha256", say("json.sha256"));
    reader.adopt(object);

    (void)reader.object("design");
    if (const auto problem = reader.problem()) return fail(ErrorKind::input, *problem);
    auto design = design_from((*json)["design"], "design.");
    if (!design) return tl::unexpected(design.error());
    project.design = std::move(*design);
    return project;
}

}  // namespace snug
