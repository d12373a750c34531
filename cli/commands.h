#pragma once

#include <functional>

#include <CLI/CLI.hpp>

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

// Each adds its subcommand to the program and sets `chosen` when that subcommand is the one that was called.
void add_make(CLI::App& program, Command& chosen);
void add_inspect(CLI::App& program, Command& chosen);
void add_sample(CLI::App& program, Command& chosen);
void add_presets(CLI::App& program, Command& chosen);
void add_cases(CLI::App& program, Command& chosen);
void add_studio(CLI::App& program, Command& chosen);

}  // namespace snug::cli
