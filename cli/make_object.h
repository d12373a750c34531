#pragma once

#include <filesystem>
#include <optional>

#include "snug/base/result.h"
#include "snug/design/project.h"
#include "snug/object/object.h"

#include "cli/console.h"

namespace snug::cli {

/// What is to be made, and from which file.
struct Task {
    std::filesystem::path object_path;
    Project project;
    /// A project's object as it was when the project was made; none for an object alone.
    std::optional<ObjectFile> expected;
    bool units_typed = false;    ///< on this command line, not in the project
    std::optional<bool> stream;  ///< whether to read in pieces; none: where the file is large
};

struct ReadObject {
    Object object;
    double read_ms = 0;  ///< none of an object that is read in pieces
};

/// Reads and prepares the object, whole or to be read in pieces; fills in the project's object. Errors name
/// the file.
[[nodiscard]] Result<ReadObject> read_object_of(Task& task, StatusLine& status);

}  // namespace snug::cli
