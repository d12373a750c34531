#include "cli/typed_words.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <variant>

namespace snug::cli {
namespace {

std::vector<std::string> parts(std::string_view text, char between) {
    std::vector<std::string> all;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(between, from), text.size());
        if (to > from) all.emplace_back(text.substr(from, to - from));
        from = to + 1;
    }
    return all;
}

/// "auto" and "-x", but no "MM", "30x18x18" or "80x40[x25]", which tell the form of something.
bool is_word(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    const auto fits = [](unsigned char c) {
        return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-';
    };
    return !text.empty() && std::islower(static_cast<unsigned char>(text.front())) != 0 &&
           std::all_of(text.begin(), text.end(), fits);
}

bool is_named(const Argument& argument) {
    return argument.name.starts_with('-');
}

bool repeats(const Argument& argument) {
    const auto* flag = std::get_if<DesignFlag>(&argument.target);
    return (flag != nullptr && flag->repeats) ||
           std::holds_alternative<std::vector<std::string>*>(argument.target);
}

Typed typed_for(const Argument& argument, const std::vector<std::string>& words) {
    const std::string& what = is_named(argument) || !argument.takes.empty() ? argument.takes : argument.name;
    if (what.empty()) return Typed::nothing;
    if (what == "FILE" || what.starts_with("OBJECT")) return Typed::file;
    if (what == "DIR") return Typed::folder;
    return words.empty() ? Typed::anything : Typed::words;
}

}  // namespace

TypedArgument as_typed(const Argument& argument) {
    TypedArgument typed;
    if (is_named(argument)) typed.names = parts(argument.name, ',');
    typed.words = parts(argument.takes, '|');
    std::erase_if(typed.words, [](const std::string& word) { return !is_word(word); });
    typed.typed = typed_for(argument, typed.words);
    typed.repeats = repeats(argument);
    typed.takes = is_named(argument) || !argument.takes.empty() ? argument.takes : argument.name;
    typed.help = argument.help;
    return typed;
}

std::string joined_words(const std::vector<std::string>& words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : std::string(between)) + word;
    return text;
}

std::vector<TypedArgument> typed_arguments(const CommandSpec& command, Language language) {
    std::vector<TypedArgument> all;
    for (const Argument& argument : command.arguments) all.push_back(as_typed(argument));
    all.push_back(as_typed(help_argument(language)));
    all.push_back(as_typed(language_argument(language)));
    return all;
}

std::vector<TypedArgument> program_arguments(Language language) {
    return {as_typed(help_argument(language)), as_typed(language_argument(language)),
            as_typed(version_argument(language))};
}

std::string place_of(const Argument& argument) {
    if (is_named(argument)) return "";
    return argument.name + (repeats(argument) ? " ..." : "");
}

}  // namespace snug::cli
