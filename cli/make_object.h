#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/project.h"
#include "snug/object/object.h"

#include "cli/console.h"

namespace snug::cli {

/// What is to be made, and from which files.
struct Task {
    std::vector<std::filesystem::path> paths;  ///< of each object
    Project project;
    /// A project's objects as they were when the project was made; empty for objects alone.
    std::vector<ProjectObject> expected;
    bool units_typed = false;    ///< on this command line, not in the project
    std::optional<bool> stream;  ///< whether to read in pieces; none: where the file is large
};

struct ReadObjects {
    std::vector<Object> objects;
    double read_ms = 0;  ///< none of an object that is read in pieces
};

/// Reads and prepares the objects, whole or to be read in pieces; fills in the project's. Errors name the
/// file.
[[nodiscard]] Result<ReadObjects> read_objects_of(Task& task, StatusLine& status);

}  // namespace snug::cli
