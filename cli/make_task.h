#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/flags.h"
#include "snug/words/words.h"

#include "cli/make_object.h"

namespace snug::cli {

/// What is typed of objects and a design, for every command that packs them.
struct TaskArguments {
    std::vector<std::string> objects;
    std::vector<TypedFlag> design;
    std::optional<std::string> replacement_object;  ///< --object
    bool stream = false, no_stream = false;
};

/// Which objects, and the design with what was typed; unless it is a project's it is not checked before its
/// items are known. Fails with kind `usage`, and with kind `input` for a project that cannot be read.
[[nodiscard]] Result<Task> task_from(const TaskArguments& arguments, Language language);

/// "--wall protect" is no wall but asks for some: takes it away, and says whether it was typed.
[[nodiscard]] bool take_protecting_walls(TaskArguments& arguments);

/// With the name of the file where there is one alone.
[[nodiscard]] Message in_its_file(const Task& task, const Error& error);

/// Files that were read, and stay.
[[nodiscard]] std::vector<std::filesystem::path> inputs_of(const TaskArguments& arguments, const Task& task);

}  // namespace snug::cli
