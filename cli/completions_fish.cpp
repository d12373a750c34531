#include <string_view>

#include "cli/completions.h"
#include "cli/typed_words.h"

namespace snug::cli {
namespace {

std::string fish_quoted(std::string_view text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result + "'";
}

/// What follows a flag, or stands in a place.
std::string fish_values(const TypedArgument& argument) {
    const std::string words = joined_words(argument.words);
    switch (argument.typed) {
        case Typed::nothing:
            return "";
        case Typed::file:
            return " -r -F";
        case Typed::folder:
            return " -x -a '(__fish_complete_directories)'";
        case Typed::words:
        case Typed::anything:
            break;
    }
    return words.empty() ? " -x" : " -x -a " + fish_quoted(words);
}

std::string fish_line(const std::string& condition, const TypedArgument& argument) {
    std::string text = "complete -c snug -n '" + condition + "'";
    for (const std::string& name : argument.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (!argument.names.empty())
        return text + fish_values(argument) + " -d " + fish_quoted(argument.help) + "\n";
    if (argument.typed == Typed::file) return text + " -F\n";
    const std::string words = joined_words(argument.words);
    return words.empty() ? "" : text + " -a " + fish_quoted(words) + "\n";
}

}  // namespace

std::string fish_completions(std::span<const CommandSpec> commands, Language language) {
    std::string text = "# What fish completes of the command lines of snug.\ncomplete -c snug -f\n";
    for (const TypedArgument& argument : program_arguments(language))
        text += fish_line("__fish_use_subcommand", argument);
    for (const CommandSpec& command : commands) {
        text += "complete -c snug -n __fish_use_subcommand -a " + command.name + " -d " +
                fish_quoted(command.help) + "\n";
        for (const TypedArgument& argument : typed_arguments(command, language))
            text += fish_line("__fish_seen_subcommand_from " + command.name, argument);
    }
    return text;
}

}  // namespace snug::cli
