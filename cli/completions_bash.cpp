#include <string_view>

#include "cli/completions.h"
#include "cli/typed_words.h"

namespace snug::cli {
namespace {

constexpr std::string_view kBashBegin = R"(# What bash completes of the command lines of snug.
_snug() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= words= place= i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${COMP_WORDS[i]} in
            COMMANDS)
                command=${COMP_WORDS[i]}
                break
                ;;
        esac
    done
    COMPREPLY=()
    case $command:$before in
)";

constexpr std::string_view kBashBetween = R"(    esac
    case $command in
)";

constexpr std::string_view kBashEnd = R"(    esac
    if [[ $word == -* || $place == words ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    elif [[ $place == files ]]; then
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
    fi
}
complete -o filenames -F _snug snug
)";

std::string bash_row(const std::string& pattern, const std::string& action) {
    return "        " + pattern + ")\n            " + action + "\n            ;;\n";
}

/// What follows a flag.
std::string value_row(const std::string& command, const TypedArgument& argument) {
    std::vector<std::string> patterns;
    for (const std::string& name : argument.names) patterns.push_back(command + ":" + name);
    const std::string pattern = joined_words(patterns, "|");
    const auto offer = [](const std::string& what) {
        return "mapfile -t COMPREPLY < <(compgen " + what + " -- \"$word\"); return";
    };
    switch (argument.typed) {
        case Typed::nothing:
            return "";
        case Typed::words:
            return bash_row(pattern, offer("-W '" + joined_words(argument.words) + "'"));
        case Typed::file:
            return bash_row(pattern, offer("-f"));
        case Typed::folder:
            return bash_row(pattern, offer("-d"));
        case Typed::anything:
            return bash_row(pattern, "return");
    }
    return "";
}

/// What stands behind a command: its flags, and what its place takes.
std::string words_row(const std::string& command, const std::vector<TypedArgument>& arguments,
                      std::vector<std::string> words) {
    std::string place = words.empty() ? "" : " place=words";
    for (const TypedArgument& argument : arguments) {
        words.insert(words.end(), argument.names.begin(), argument.names.end());
        if (!argument.names.empty()) continue;
        words.insert(words.end(), argument.words.begin(), argument.words.end());
        if (argument.typed == Typed::words) place = " place=words";
        if (argument.typed == Typed::file) place = " place=files";
    }
    return bash_row(command, "words='" + joined_words(words) + "'" + place);
}

}  // namespace

std::string bash_completions(std::span<const CommandSpec> commands, Language language) {
    std::vector<std::string> names;
    std::string values, words;
    const auto add = [&](const std::string& name, const std::string& pattern,
                         const std::vector<TypedArgument>& arguments, const std::vector<std::string>& more) {
        for (const TypedArgument& argument : arguments)
            if (!argument.names.empty()) values += value_row(name, argument);
        words += words_row(pattern, arguments, more);
    };
    for (const CommandSpec& command : commands) {
        names.push_back(command.name);
        add(command.name, command.name, typed_arguments(command, language), {});
    }
    add("", "''", program_arguments(language), names);
    std::string begin(kBashBegin);
    const std::string_view all = "COMMANDS";
    begin.replace(begin.find(all), all.size(), joined_words(names, "|"));
    return begin + values + std::string(kBashBetween) + words + std::string(kBashEnd);
}

}  // namespace snug::cli
