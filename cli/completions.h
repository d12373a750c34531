#pragma once

#include <span>
#include <string>

#include "cli/arguments.h"

// What a shell completes the program's command lines by.

namespace snug::cli {

[[nodiscard]] std::string bash_completions(std::span<const CommandSpec> commands, Language language);
[[nodiscard]] std::string zsh_completions(std::span<const CommandSpec> commands, Language language);
[[nodiscard]] std::string fish_completions(std::span<const CommandSpec> commands, Language language);

}  // namespace snug::cli
