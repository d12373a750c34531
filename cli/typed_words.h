#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments.h"

// An argument as something is typed for it: for what a shell completes, and for the manual page.

namespace snug::cli {

/// What follows it, or stands for it where it has no name.
enum class Typed { nothing, words, file, folder, anything };

struct TypedArgument {
    std::vector<std::string> names;  ///< "-o", "--output"; none where its place says what it is
    Typed typed = Typed::nothing;
    std::vector<std::string> words;  ///< those of it that are not for the person to find
    bool repeats = false;
    std::string takes, help;  ///< as in the help
};

[[nodiscard]] TypedArgument as_typed(const Argument& argument);

[[nodiscard]] std::string joined_words(const std::vector<std::string>& words, std::string_view between = " ");

/// Of a command: its own, then what every command takes.
[[nodiscard]] std::vector<TypedArgument> typed_arguments(const CommandSpec& command, Language language);

/// Of the program before any command.
[[nodiscard]] std::vector<TypedArgument> program_arguments(Language language);

/// "OBJECT ..." or "NAME"; empty for what has names.
[[nodiscard]] std::string place_of(const Argument& argument);

}  // namespace snug::cli
