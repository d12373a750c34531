#pragma once

#include <functional>
#include <vector>

#include "snug/words/words.h"

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

// Each describes its command, which prints in the language.
[[nodiscard]] CommandSpec make_command(Language language);
[[nodiscard]] CommandSpec plan_command(Language language);
[[nodiscard]] CommandSpec inspect_command(Language language);
[[nodiscard]] CommandSpec sample_command(Language language);
[[nodiscard]] CommandSpec shape_command(Language language);
[[nodiscard]] CommandSpec presets_command(Language language);
[[nodiscard]] CommandSpec cases_command(Language language);
[[nodiscard]] CommandSpec foams_command(Language language);
[[nodiscard]] CommandSpec studio_command(Language language);
[[nodiscard]] CommandSpec generate_command(Language language);

/// In the order of the help.
[[nodiscard]] std::vector<CommandSpec> all_commands(Language language);

}  // namespace snug::cli
