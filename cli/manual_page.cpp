#include "cli/manual_page.h"

#include <string_view>
#include <utility>

#include "snug/words/words.h"

#include "cli/typed_words.h"

namespace snug::cli {
namespace {

/// So that nothing in it steers the page.
std::string roff(std::string_view text) {
    std::string page;
    bool first = true;
    for (const char c : text) {
        if (first && (c == '.' || c == '\'')) page += "\\&";
        if (c == '\\' || c == '-') page += '\\';
        page += c == '\\' ? 'e' : c;
        first = c == '\n';
    }
    return page;
}

std::string roff_bold(std::string_view text) {
    return "\\fB" + roff(text) + "\\fR";
}

std::string roff_slanted(std::string_view text) {
    return "\\fI" + roff(text) + "\\fR";
}

std::string roff_heading(std::string_view text) {
    return ".SH " + roff(text) + "\n";
}

std::string roff_entry(const std::string& name, const std::string& help) {
    return ".TP\n" + name + "\n" + roff(help) + "\n";
}

std::string roff_entry(const TypedArgument& argument) {
    std::string names;
    for (const std::string& name : argument.names) names += (names.empty() ? "" : ", ") + roff_bold(name);
    return roff_entry(names + (argument.takes.empty() ? "" : " " + roff_slanted(argument.takes)),
                      argument.help);
}

/// One, or several lines that each begin with a line end.
std::string roff_examples(const std::string& lines, Language language) {
    std::string page =
        ".PP\n" + roff(text(say("help.examples", {{"examples", std::string()}}), language)) + "\n.nf\n";
    return page + roff(lines.starts_with('\n') ? lines.substr(1) : "  " + lines) + "\n.fi\n";
}

std::string roff_command(const CommandSpec& command, Language language) {
    std::string places, entries;
    for (const Argument& argument : command.arguments) {
        const std::string place = place_of(argument);
        if (place.empty()) continue;
        places += " " + (argument.required ? roff_slanted(place) : "[" + roff_slanted(place) + "]");
        entries += roff_entry(roff_slanted(place), argument.help);
    }
    for (const TypedArgument& argument : typed_arguments(command, language))
        if (!argument.names.empty()) entries += roff_entry(argument);
    return ".SS " + roff("snug " + command.name) + "\n" + roff(command.help) + "\n.PP\n" +
           roff_bold("snug " + command.name) + " [" + roff_slanted(text(say("manual.options"), language)) +
           "]" + places + "\n" + entries + roff_examples(command.examples, language);
}

}  // namespace

std::string manual_page(std::span<const CommandSpec> commands, Language language) {
    const auto said = [&](const Message& message) { return text(message, language); };
    std::string page = ".TH SNUG 1 \"\" \"snug " SNUG_VERSION "\"\n";
    page += roff_heading(said(say("manual.name"))) + "snug \\- " + roff(said(say("manual.what"))) + "\n";
    page += roff_heading(said(say("manual.synopsis"))) + roff_bold("snug") + " [" +
            roff_slanted(said(say("manual.options"))) + "] " + roff_slanted(said(say("manual.command"))) +
            "\n";
    page += roff_heading(said(say("manual.description"))) + roff(said(say("help.snug"))) + "\n";
    page += roff_heading(said(say("manual.options")));
    for (const TypedArgument& argument : program_arguments(language)) page += roff_entry(argument);
    page += roff_heading(said(say("manual.commands")));
    for (const CommandSpec& command : commands) page += roff_command(command, language);
    page += roff_heading(said(say("manual.status")));
    for (const auto& [status, meaning] :
         {std::pair{kDone, say("manual.done")}, std::pair{kWrongUsage, say("manual.wrong_usage")},
          std::pair{kBadInput, say("manual.bad_input")}, std::pair{kDoesNotFit, say("manual.does_not_fit")},
          std::pair{kCannotWrite, say("manual.cannot_write")},
          std::pair{kCancelled, say("manual.cancelled")}})
        page += roff_entry(roff_bold(std::to_string(static_cast<int>(status))), said(meaning));
    return page;
}

}  // namespace snug::cli
