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

}  // namespace

Result<ObjectSource> find_object(const std::string& argument, const std::optional<std::string>& replacement) {
    const fs::path path = argument;
    if (!is_project(path)) {
        if (replacement) return fail(ErrorKind::usage, say("usage.object"));
        return ObjectSource{path, {}};
    }
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto project = parse_project({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!project) return fail(ErrorKind::input, in_file(path.string(), project.error().message));
    const fs::path object = replacement ? fs::path(*replacement) : path.parent_path() / project->object.name;
    std::error_code error;
    if (!fs::exists(object, error))
        return fail(ErrorKind::input,
                    say("project.object_gone", {{"file", path.string()}, {"object", object.string()}}));
    return ObjectSource{object, std::move(*project)};
}

}  // namespace snug::cli
