#include "snug/design/options_page.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "snug/base/text.h"
#include "snug/design/flags.h"
#include "snug/design/option_json.h"
#include "snug/design/option_text.h"
#include "snug/design/options_schema.h"

namespace snug {
namespace {

constexpr std::string_view kIntroduction = R"(# The options of a design

Everything that a person chooses, by the stage of the method that it belongs to. Each option has a name in a project file
(`project.snug.json`, below `design`), and most have a flag of `snug make`. Where several options share a flag, the flag
says them together, and `snug make --help` shows how. Every option, also one without a flag, can be typed by its name:
`--set fit.least_rib_mm=20`, in the form that a project file has; `--set` comes after all other flags. A default in
brackets follows from other choices. The scope says whose choice it is: the whole design's, an object's (a file), or
an item's (an object as it lies in the case). Items are a list, of which the first is shown; what an item leaves open
is as the design has it for all, and behind `OBJECT:` stands what it may say of itself on the command line. Large
numbers are grouped here to be read; they are typed without commas.

This page is made from the table of options: `SNUG_WRITE=1 build/tests/snug_tests --gtest_filter=OptionsPage.*` writes it.
)";

constexpr std::string_view kFirstItem = "items.0";

/// A bar would end a cell of the table.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

std::string code(std::string_view text) {
    return text.empty() ? "" : "`" + cell(text) + "`";
}

std::string quoted_words(std::span<const std::string_view> words) {
    std::string text;
    for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + code(word);
    return text;
}

/// "0.000000001", "1,000,000"
std::string readable(double value) {
    std::string text = number(std::abs(value), 9);
    for (std::size_t at = std::min(text.find('.'), text.size()); at > 3;) text.insert(at -= 3, ",");
    return (value < 0 ? "-" : "") + text;
}

/// Of an option without a range: "text", "4 numbers", "`2x4,1x2,...`"
std::string any_value(const Option& option) {
    if (kind_of(option) == "words") return code(option.row.takes);
    const int count = count_of(option);
    return (count > 0 ? std::to_string(count) + " " : "") + std::string(kind_of(option));
}

/// "0.5 to 100 mm", "`studs`, `tiles`", "on or off"
std::string values_of(const Option& option) {
    const OptionRow& row = option.row;
    const std::string unit = row.unit.empty() ? "" : " " + std::string(row.unit.english);
    if (const auto* choice = std::get_if<Choice>(&option.value)) return quoted_words(choice->words);
    if (!row.words.empty()) return quoted_words(row.words);
    if (kind_of(option) == "switch") return "on or off";
    if (row.range.any()) return any_value(option) + unit;
    const std::string least = readable(row.range.least), most = readable(row.range.most);
    if (row.range.most >= std::numeric_limits<int>::max()) return least + " or more" + unit;
    if (row.range.above) return "above " + least + ", at most " + most + unit;
    return (row.range.or_zero ? "0, or " : "") + least + " to " + most + unit;
}

/// As it is typed, with what it stands for where its row says so ("0: none"); in brackets what follows from
/// other choices.
std::string default_of(const Option& option) {
    const std::string usual(option.row.usual.english);
    if (kind_of(option) == "switch") return text_of(option) ? "on" : "off";
    const bool none = json_of(option).is_null();
    const std::string text = text_of(option).value_or("");
    const bool explained = usual.rfind(text + ": ", 0) == 0;
    if (!none && !text.empty()) return code(text) + (explained ? usual.substr(text.size()) : "");
    return usual.empty() ? "none" : "(" + usual + ")";
}

std::string line_of(const Option& option) {
    const OptionRow& row = option.row;
    const std::string flag =
        row.word.empty() ? std::string(row.flag) : "OBJECT:" + std::string(row.word) + "=";
    return "| " + code(option.path) + " | " + code(flag) + " | " + values_of(option) + " | " +
           cell(default_of(option)) + " | " + std::string(name_of(row.scope)) + " | " +
           cell(row.help.english) + " |\n";
}

}  // namespace

std::string options_page() {
    Design design;
    const OptionList list = all_options(design);
    std::string page(kIntroduction);
    for (const OptionGroup& group : list.groups) {
        std::string lines;
        for (const Option& option : list.options)
            if (option.path.substr(0, option.path.rfind('.')) == group.path) lines += line_of(option);
        if (group.list) continue;  // its structs tell
        const bool nested = group.path.find('.') != std::string::npos && group.path != kFirstItem;
        page += "\n" + std::string(nested ? "### " : "## ") + std::string(group.row.title.english) + "\n\n" +
                "| Option | Flag | Values | Default | Scope | What it does |\n|---|---|---|---|---|---|\n" +
                lines;
    }
    return page;
}

}  // namespace snug
