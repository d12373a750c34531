#pragma once

#include <functional>

namespace snug::cli {

/// Exit statuses, fixed because scripts rely on them.
enum ExitStatus {
    kDone = 0,
    kWrongUsage = 1,
    kBadInput = 2,
    kDoesNotFit = 3,
    kCannotWrite = 4,
    kCancelled = 5,
};

/// A command that was parsed and is ready to run; gives the exit status.
using Command = std::function<int()>;

struct CommandSpec;  // arguments.h

// Each describes its command.
[[nodiscard]] CommandSpec make_command();
[[nodiscard]] CommandSpec inspect_command();
[[nodiscard]] CommandSpec sample_command();
[[nodiscard]] CommandSpec presets_command();
[[nodiscard]] CommandSpec cases_command();
[[nodiscard]] CommandSpec studio_command();

}  // namespace snug::cli
