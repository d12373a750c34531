#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/object_argument.h"
#include "snug/design/project.h"

namespace snug::cli {

/// What a command is given to work on: objects, or a project and the objects that it speaks of.
struct ObjectSources {
    std::vector<std::filesystem::path> paths;  ///< of each object, in the project's order
    std::optional<Project> project;            ///< none where objects were typed
    std::vector<ObjectArgument> typed;         ///< and then what was typed
};

/// `arguments` are meshes, each with choices of its own if you like, or one project (*.snug.json), whose
/// objects lie beside it or, where it has one alone, at `replacement`. A path that exists as it was typed is
/// taken whole, colons included. Fails (input, usage) with a sentence that names the file.
[[nodiscard]] Result<ObjectSources> find_objects(const std::vector<std::string>& arguments,
                                                 const std::optional<std::string>& replacement = {});

/// The same for commands that take one object.
struct ObjectSource {
    std::filesystem::path object;
    std::optional<Project> project;
};
[[nodiscard]] Result<ObjectSource> find_object(const std::string& argument,
                                               const std::optional<std::string>& replacement = {});

}  // namespace snug::cli
