#include "cli/arguments.h"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/design/option_text.h"

namespace snug::cli {
namespace {

/// Written so that what is no number at all fails as well.
CLI::Validator within_range(double least, double most) {
    const std::string range = number(least) + " to " + number(most);
    return {[least, most, range](std::string& text) {
                const auto value = typed_number(text);
                return value && *value >= least && *value <= most
                           ? std::string()
                           : "takes " + range + ", not " + snug::quoted(text);
            },
            range};
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

void add(CLI::App& app, const std::vector<Argument>& arguments) {
    std::map<std::string, CLI::Option*> added;
    for (const Argument& argument : arguments) {
        CLI::Option* const option = std::visit(Adding{app, argument}, argument.target);
        added[argument.name] = option;
        if (!argument.takes.empty()) option->type_name(argument.takes);
        if (argument.required) option->required();
        if (argument.range) option->check(within_range(argument.range->first, argument.range->second));
        for (const std::string& name : argument.needs) option->needs(added.at(name));
        for (const std::string& name : argument.excludes) option->excludes(added.at(name));
    }
}

}  // namespace

int run_program(int argc, const char* const* argv, const CommandSpec& program,
                const std::vector<CommandSpec>& commands) {
    CLI::App app(program.help, program.name);
    app.set_version_flag("--version", "snug " SNUG_VERSION);
    app.set_help_flag("-h,--help", "Print this help");
    app.require_subcommand(1);
    app.footer(program.footer);
    const CommandSpec* chosen = nullptr;
    for (const CommandSpec& command : commands) {
        CLI::App* const added = app.add_subcommand(command.name, command.help);
        add(*added, command.arguments);
        added->footer(command.footer);
        added->callback([&chosen, &command] { chosen = &command; });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kDone : kWrongUsage;
    }
    return chosen->run();
}

}  // namespace snug::cli
