#include "cli/object_file.h"

#include <string_view>
#include <system_error>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/files.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

bool is_project(const fs::path& path) {
    constexpr std::string_view kEnding = ".snug.json";
    const std::string name = path.filename().string();
    return name.size() >= kEnding.size() &&
           name.compare(name.size() - kEnding.size(), kEnding.size(), kEnding) == 0;
}

ObjectArgument argument_of(const std::string& text) {
    std::error_code error;
    return fs::exists(text, error) ? ObjectArgument{text, {}} : object_argument(text);
}

Result<ObjectSources> from_project(const fs::path& path, const std::optional<std::string>& replacement) {
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto project = parse_project({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!project) return fail(ErrorKind::input, in_file(path.string(), project.error().message));
    const bool several = project->objects.size() > 1;
    std::error_code error;
    const bool folder = replacement && fs::is_directory(*replacement, error);
    if (replacement && several && !folder)
        return fail(ErrorKind::usage,
                    in_file(path.string(), say("project.several", {{"objects", project->objects.size()}})));
    ObjectSources sources;
    for (const ProjectObject& object : project->objects) {
        const fs::path beside = folder ? fs::path(*replacement) : path.parent_path();
        const fs::path at = replacement && !folder ? fs::path(*replacement) : beside / object.file.name;
        // What is made of measurements is in the project, whatever lies beside it.
        if (!fs::exists(at, error) && (replacement || object.file.shape.empty()))
            return fail(ErrorKind::input, say(several ? "project.object_gone/several" : "project.object_gone",
                                              {{"file", path.string()}, {"object", at.string()}}));
        sources.paths.push_back(at);
    }
    sources.project = std::move(*project);
    return sources;
}

}  // namespace

Result<ObjectSources> find_objects(const std::vector<std::string>& arguments,
                                   const std::optional<std::string>& replacement) {
    ObjectSources sources;
    for (const std::string& text : arguments) {
        ObjectArgument argument = argument_of(text);
        if (!is_project(argument.file)) {
            sources.typed.push_back(std::move(argument));
            continue;
        }
        if (arguments.size() > 1 || !argument.choices.empty())
            return fail(ErrorKind::usage, in_file(argument.file, say("object.with_project")));
        return from_project(argument.file, replacement);
    }
    if (replacement) return fail(ErrorKind::usage, say("usage.object"));
    return sources;
}

Result<ObjectSource> find_object(const std::string& argument, const std::optional<std::string>& replacement) {
    if (!is_project(argument)) {
        if (replacement) return fail(ErrorKind::usage, say("usage.object"));
        return ObjectSource{argument, {}};
    }
    auto sources = from_project(argument, replacement);
    if (!sources) return tl::unexpected(sources.error());
    if (sources->project->design.items.size() > 1)
        return fail(ErrorKind::usage,
                    in_file(argument, say("project.several_items",
                                          {{"items", sources->project->design.items.size()}})));
    take_over_one_item(*sources->project);
    return ObjectSource{sources->paths.front(), std::move(sources->project)};
}

}  // namespace snug::cli
