#include "cli/arguments.h"

#include <cstdio>
#include <map>
#include <regex>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/design/option_text.h"
#include "snug/words/words.h"

namespace snug::cli {
namespace {

/// Written so that what is no number at all fails as well.
CLI::Validator within_range(double least, double most, Language language) {
    const std::string from = number(least), to = number(most);
    return {
        [least, most, from, to](std::string& typed) {
            const auto value = typed_number(typed);
            return value && *value >= least && *value <= most
                       ? std::string()
                       : "takes " + from + " to " + to + ", not " + snug::quoted(typed);
        },
        text(say("in_both", {{"english", from + " to " + to}, {"japanese", from + "～" + to}}), language)};
}

/// Makes the option that an argument describes.
struct Adding {
    CLI::App& app;
    const Argument& argument;

    CLI::Option* operator()(bool* target) const {
        return app.add_flag(argument.name, *target, argument.help);
    }
    CLI::Option* operator()(const DesignFlag& flag) const {
        const auto keep = [typed = flag.typed, name = argument.name](const std::string& text) {
            typed->push_back({name, text});
        };
        if (argument.takes.empty())
            return app.add_flag_callback(
                argument.name, [keep] { keep(""); }, argument.help);
        if (flag.repeats)
            return app
                .add_option_function<std::vector<std::string>>(
                    argument.name,
                    [keep](const std::vector<std::string>& texts) {
                        for (const std::string& text : texts) keep(text);
                    },
                    argument.help)
                ->allow_extra_args(false);
        if (!flag.many) return app.add_option_function<std::string>(argument.name, keep, argument.help);
        const auto join = [keep](const std::vector<std::string>& words) {
            std::string text;
            for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
            keep(text);
        };
        return app.add_option_function<std::vector<std::string>>(argument.name, join, argument.help)
            ->delimiter(',');
    }
    template <class T>
    CLI::Option* operator()(T* target) const {
        return app.add_option(argument.name, *target, argument.help);
    }
};

void add(CLI::App& app, const std::vector<Argument>& arguments, Language language) {
    std::map<std::string, CLI::Option*> added;
    for (const Argument& argument : arguments) {
        CLI::Option* const option = std::visit(Adding{app, argument}, argument.target);
        added[argument.name] = option;
        if (!argument.takes.empty()) option->type_name(argument.takes);
        if (argument.required) option->required();
        if (argument.range)
            option->check(within_range(argument.range->first, argument.range->second, language));
        for (const std::string& name : argument.needs) option->needs(added.at(name));
        for (const std::string& name : argument.excludes) option->excludes(added.at(name));
    }
}

/// A sentence of the library that reads command lines, and what it says in words of our own. Each bracket is
/// the value of that name.
struct Refusal {
    const char* pattern;
    const char* code;
    std::vector<const char*> values;
};

const std::vector<Refusal>& refusals() {
    static const std::vector<Refusal> known{
        {"(.*): takes (.*) to (.*), not (.*)", "usage.range", {"name", "least", "most", "found"}},
        {"A subcommand is required", "usage.no_command", {}},
        {"(.*) is required", "usage.required", {"name"}},
        {"(.*) requires (.*)", "usage.requires", {"name", "other"}},
        {"(.*) excludes (.*)", "usage.excludes", {"name", "other"}},
        {"Could not convert: (.*) = (.*)", "usage.no_number", {"name", "found"}},
        {"(.*): 1 required (.*) missing", "usage.no_value", {"name", "takes"}},
        {"(.*) was given a disallowed flag override", "usage.flag_value", {"name"}},
    };
    return known;
}

Message refusal_of(const CLI::ParseError& error) {
    const std::string said = error.what();
    std::smatch found;
    // CLI11 joins them by a space each.
    if (std::regex_match(said, found, std::regex("The following arguments? (was|were) not expected: ([^]*)")))
        return say("usage.not_expected", {{"count", found[1] == "was" ? 1U : 2U}, {"names", found[2].str()}});
    for (const Refusal& refusal : refusals()) {
        if (!std::regex_match(said, found, std::regex(refusal.pattern))) continue;
        std::vector<Value> values;
        for (std::size_t i = 0; i < refusal.values.size(); ++i)
            values.emplace_back(refusal.values[i], found[i + 1].str());
        return say(refusal.code, values);
    }
    return say("usage.other", {{"problem", said}});
}

/// Help goes to standard output, what is wrong to standard error.
int status_at_end(const CLI::App& app, const CLI::ParseError& error, Language language) {
    if (error.get_exit_code() == 0) return app.exit(error) == 0 ? kDone : kWrongUsage;
    fmt::print(stderr, "{}\n{}\n", text(refusal_of(error), language), text(say("usage.see_help"), language));
    return kWrongUsage;
}

std::string footer(const std::string& examples, Language language) {
    return text(examples.starts_with('\n') ? say("help.examples", {{"examples", examples}})
                                           : say("help.example", {{"example", examples}}),
                language);
}

/// The words of the help that are not those of an argument.
void translate(CLI::App& app, Language language) {
    const auto said = [&](const Message& message) { return text(message, language); };
    const Argument help_flag = help_argument(language);
    app.set_help_flag(help_flag.name, help_flag.help);
    app.option_defaults()->group(said(say("help.options")));
    if (CLI::Option* const help = app.get_help_ptr()) help->group(said(say("help.options")));
    const std::map<std::string, Message> labels{
        {"Positionals", say("help.positionals")}, {"Usage", say("help.usage")},
        {"REQUIRED", say("help.required")},       {"Needs", say("help.needs")},
        {"Excludes", say("help.excludes")},       {"OPTIONS", say("help.option_list")},
        {"SUBCOMMAND", say("help.command")}};
    for (const auto& [label, message] : labels) app.get_formatter()->label(label, said(message));
}

}  // namespace

Argument help_argument(Language language) {
    return {"-h,--help", "", text(say("help.help"), language), static_cast<bool*>(nullptr)};
}

Argument language_argument(Language language) {
    return {"--language", "en|ja", text(say("help.language"), language), static_cast<std::string*>(nullptr)};
}

Argument version_argument(Language language) {
    return {"--version", "", text(say("help.version"), language), static_cast<bool*>(nullptr)};
}

Result<Language> typed_language(int argc, const char* const* argv) {
    constexpr std::string_view kFlag = "--language";
    for (int i = 1; i < argc && argv[i] != std::string_view("--"); ++i) {
        const std::string_view word = argv[i];
        std::string_view typed;
        if (word == kFlag && i + 1 < argc)
            typed = argv[i + 1];
        else if (word.starts_with(kFlag) && word.substr(kFlag.size()).starts_with('='))
            typed = word.substr(kFlag.size() + 1);
        else
            continue;
        if (const auto language = language_from_name(typed)) return *language;
        const std::vector<std::string_view> known{language_name(Language::english),
                                                  language_name(Language::japanese)};
        return not_what_it_takes(kFlag, say("takes.one_of", {{"words", each_as_it_is(known)}}), typed);
    }
    return Language::english;
}

int run_program(int argc, const char* const* argv, Language language,
                const std::vector<CommandSpec>& commands) {
    const auto said = [&](const Message& message) { return text(message, language); };
    CLI::App app(said(say("help.snug")), "snug");
    translate(app, language);
    std::string ignored;  // typed_language() has read it
    const auto add_language = [&](CLI::App& to) {
        const Argument argument = language_argument(language);
        to.add_option(argument.name, ignored, argument.help)->type_name(argument.takes);
    };
    add_language(app);
    const Argument version = version_argument(language);
    app.set_version_flag(version.name, "snug " SNUG_VERSION, version.help)->group(said(say("help.options")));
    app.require_subcommand(1);
    app.footer(footer("snug make vase.stl -o vase-foam", language) + "\n" + said(say("help.every_command")));
    const CommandSpec* chosen = nullptr;
    for (const CommandSpec& command : commands) {
        CLI::App* const added = app.add_subcommand(command.name, command.help);
        translate(*added, language);
        added->group(said(say("help.commands")));
        add(*added, command.arguments, language);
        add_language(*added);
        added->footer(footer(command.examples, language));
        added->callback([&chosen, &command] { chosen = &command; });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return status_at_end(app, error, language);
    }
    return chosen->run();
}

}  // namespace snug::cli
