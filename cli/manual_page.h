#pragma once

#include <span>
#include <string>

#include "cli/arguments.h"

namespace snug::cli {

/// The manual page of the program, for `man`: what --help says of all commands, and the exit statuses.
[[nodiscard]] std::string manual_page(std::span<const CommandSpec> commands, Language language);

}  // namespace snug::cli
