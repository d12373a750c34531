#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "snug/base/result.h"
#include "snug/design/project.h"

namespace snug::cli {

/// What a command is given to work on: a mesh, or a project and the mesh that it speaks of.
struct ObjectSource {
    std::filesystem::path object;
    std::optional<Project> project;
};

/// `argument` is a mesh or a project (*.snug.json), whose object lies beside it or at `replacement`. Fails
/// (input, usage) with a sentence that names the file.
[[nodiscard]] Result<ObjectSource> find_object(const std::string& argument,
                                               const std::optional<std::string>& replacement = {});

}  // namespace snug::cli
