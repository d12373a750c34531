#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/flags.h"
#include "snug/words/words.h"

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
using ArgumentTarget =
    std::variant<bool*, int*, std::uintmax_t*, double*, std::string*, std::vector<std::string>*,
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
    std::string name, help;
    std::string examples;  ///< one, or several lines that each begin with a line end
    std::vector<Argument> arguments;
    Command run;  ///< gives the exit status
};

// What every command takes besides; of the program as a whole the version, too.
[[nodiscard]] Argument help_argument(Language language);
[[nodiscard]] Argument language_argument(Language language);
[[nodiscard]] Argument version_argument(Language language);

/// What was typed as --language, wherever it stands, so that all that is wrong can be said in it; English
/// where it was not typed. Fails (kind `usage`) for a word that names none.
[[nodiscard]] Result<Language> typed_language(int argc, const char* const* argv);

/// Reads the command line, prints help and refusals in the language, and runs the command that was called.
[[nodiscard]] int run_program(int argc, const char* const* argv, Language language,
                              const std::vector<CommandSpec>& commands);

}  // namespace snug::cli
