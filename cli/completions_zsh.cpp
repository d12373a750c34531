#include <string_view>

#include "cli/completions.h"
#include "cli/typed_words.h"

namespace snug::cli {
namespace {

constexpr std::string_view kZshEnd = R"(        esac
    esac
}
if [ "$funcstack[1]" = "_snug" ]; then _snug "$@"; else compdef _snug snug; fi
)";

/// In single quotes, with a backslash before each of the marks that would end a part.
std::string zsh_quoted(std::string_view text, std::string_view marks) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (c == '\\' || marks.find(c) != std::string_view::npos) result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string zsh_action(const TypedArgument& argument) {
    switch (argument.typed) {
        case Typed::words:
            return "(" + joined_words(argument.words) + ")";
        case Typed::file:
            return "_files";
        case Typed::folder:
            return "_files -/";
        case Typed::nothing:
        case Typed::anything:
            break;
    }
    return " ";
}

/// One specification for each name, of which one alone is typed unless it repeats.
std::string specifications(const TypedArgument& argument) {
    const std::string indent = "                ";
    const std::string value = argument.typed == Typed::nothing
                                  ? ""
                                  : ":" + zsh_quoted(argument.takes, ":") + ":" + zsh_action(argument);
    if (argument.names.empty()) return " \\\n" + indent + "'" + (argument.repeats ? "*" : "") + value + "'";
    const std::string group = joined_words(argument.names);
    std::string all;
    for (const std::string& name : argument.names)
        all += " \\\n" + indent + "'" + (argument.repeats ? "*" : "(" + group + ")") + name + "[" +
               zsh_quoted(argument.help, "[]") + "]" + value + "'";
    return all;
}

}  // namespace

std::string zsh_completions(std::span<const CommandSpec> commands, Language language) {
    std::string names, cases, general;
    for (const CommandSpec& command : commands) {
        names += "        '" + command.name + ":" + zsh_quoted(command.help, ":") + "'\n";
        cases += "            " + command.name + ")\n                _arguments";
        for (const TypedArgument& argument : typed_arguments(command, language))
            cases += specifications(argument);
        cases += "\n                ;;\n";
    }
    for (const TypedArgument& argument : program_arguments(language)) general += specifications(argument);
    return "#compdef snug\n_snug() {\n    local curcontext=$curcontext state line\n    typeset -A opt_args\n"
           "    local -a commands=(\n" +
           names + "    )\n    _arguments -C" + general +
           " \\\n                '1: :->command' '*:: :->arguments'\n    case $state in\n"
           "        command) _describe command commands ;;\n        arguments) case $words[1] in\n" +
           cases + std::string(kZshEnd);
}

}  // namespace snug::cli
