#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "snug/design/flags.h"

#include "cli/commands.h"

// What commands take, said without the library that reads it: that one is slow to compile and stands in
// arguments.cpp alone.

namespace snug::cli {

/// Flags of the design as they are typed, one after the other.
struct DesignFlag {
    std::vector<TypedFlag>* typed = nullptr;
    bool many = false;     ///< several words may follow
    bool repeats = false;  ///< it may be typed more than once
};

/// Where a value goes. bool: typing it is enough.
using ArgumentTarget = std::variant<bool*, int*, std::uintmax_t*, double*, std::string*,
                                    std::optional<std::string>*, std::optional<double>*, DesignFlag>;

struct Argument {
    std::string name;   ///< "OBJECT", "--wall" or "-o,--output"
    std::string takes;  ///< what the help shows behind it: "MM"
    std::string help;
    ArgumentTarget target;
    bool required = false;
    std::optional<std::pair<double, double>> range = {};  ///< of a number
    std::vector<std::string> needs = {}, excludes = {};   ///< names of arguments that stand before it
};

/// A command of the program.
struct CommandSpec {
    std::string name, help, footer;
    std::vector<Argument> arguments;
    Command run;  ///< gives the exit status
};

/// Reads the command line, prints help and refusals, and runs the command that was called.
[[nodiscard]] int run_program(int argc, const char* const* argv, const CommandSpec& program,
                              const std::vector<CommandSpec>& commands);

}  // namespace snug::cli
