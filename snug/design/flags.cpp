#include "snug/design/flags.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "snug/base/text.h"
#include "snug/design/known_foams.h"
#include "snug/design/option_json.h"
#include "snug/design/option_text.h"
#include "snug/words/words.h"

namespace snug {
namespace {

const TypedFlag* find_typed(std::span<const TypedFlag> typed, std::string_view flag) {
    const auto found =
        std::find_if(typed.begin(), typed.end(), [&](const TypedFlag& each) { return each.flag == flag; });
    return found == typed.end() ? nullptr : &*found;
}

/// The help of an option with its default in brackets.
std::string with_default(const Words& help, const Words& usual, const std::optional<std::string>& text,
                         Language language) {
    const std::string shown = usual.empty() ? text.value_or("") : snug::text(said(usual), language);
    const std::string sentence = snug::text(said(help), language);
    return shown.empty() || shown == "none"
               ? sentence
               : snug::text(say("help.default", {{"help", sentence}, {"usual", shown}}), language);
}

/// As the row says it, or every word that the option may be: "studs|tiles".
std::string takes_of(const Option& option) {
    const auto* const choice = std::get_if<Choice>(&option.value);
    if (!choice || !option.row.takes.empty()) return std::string(option.row.takes);
    std::string text;
    for (const std::string_view word : choice->words) text += (text.empty() ? "" : "|") + std::string(word);
    return text + (option.row.none.empty() ? "" : "|" + std::string(option.row.none));
}

bool takes_many(const Option& option) {
    return std::holds_alternative<std::vector<std::string>*>(option.value) ||
           std::holds_alternative<std::vector<BrickStock>*>(option.value);
}

bool repeats(const Option& option) {
    return std::holds_alternative<Zones*>(option.value) || std::holds_alternative<HandEdits*>(option.value);
}

/// All that was typed behind a flag that repeats.
TypedFlag joined(std::span<const TypedFlag> typed, const std::string& flag) {
    TypedFlag all{flag, {}};
    for (const TypedFlag& each : typed)
        if (each.flag == flag) all.text += (all.text.empty() ? "" : ",") + each.text;
    return all;
}

/// Whether the text is meant as sizes ("425x284x155:45"), not as a name.
bool looks_like_sizes(std::string_view text) {
    return text.find('x') != std::string_view::npos &&
           text.find_first_not_of("0123456789.+-x:") == std::string_view::npos;
}

Result<void> take_from(const OptionList& list, const TypedFlag& typed) {
    if (const BoundFlag* flag = list.find_flag(typed.flag)) return flag->take(typed.text);
    if (const Option* option = list.find_by_flag(typed.flag)) return take_text(*option, typed.text);
    // It is of a group that does not exist.
    Design full;
    const OptionList all = all_options(full);
    const Option* const option = all.find_by_flag(typed.flag);
    if (!option) return fail(ErrorKind::usage, say("flag.no_option", {{"flag", typed.flag}}));
    const OptionGroup* const group = all.find_group(option->path.substr(0, option->path.rfind('.')));
    return fail(ErrorKind::usage, say("flag.belongs_to", {{"flag", typed.flag}, {"other", group->row.flag}}));
}

bool makes_a_group(const OptionList& list, std::string_view flag) {
    return std::any_of(list.groups.begin(), list.groups.end(),
                       [&](const OptionGroup& group) { return group.row.flag == flag; });
}

Result<void> take_preset(std::span<const TypedFlag> typed, Design& design, bool from_project,
                         const KnownNames& known) {
    const TypedFlag* const named = find_typed(typed, "--preset");
    const TypedFlag* const work = find_typed(typed, "--for");
    const bool implied = work && !named && !from_project;
    if (!named && !implied) return {};
    std::string name = named ? named->text : "";
    if (implied) {
        if (auto done = take_flag(*work, design); !done) return done;
        if (design.workshop.work == Workshop::none) return {};
        name = usual_preset(design.workshop.work);
    }
    const auto presets = known.presets();
    if (!presets) return tl::unexpected(presets.error());
    const auto preset = find_preset(*presets, name);
    if (!preset) return tl::unexpected(preset.error());
    apply(*preset, design);
    design.workshop.density_kg_m3 = preset->density_kg_m3;
    // The default count of blocks belongs to the default foam.
    if (implied) design.space.blocks.reset();
    return {};
}

/// With the foam come what it bears for long and its density.
Result<void> take_foam(std::span<const TypedFlag> typed, Design& design, const KnownNames& known) {
    const TypedFlag* const named = find_typed(typed, "--foam");
    if (!named) return {};
    design.protection.foam.reset();
    if (named->text == "none") return {};
    const auto foams = known.foams();
    if (!foams) return tl::unexpected(foams.error());
    auto foam = find_foam(*foams, named->text);
    if (!foam) return tl::unexpected(foam.error());
    apply(*foam, design);
    return {};
}

Result<void> take_case(const TypedFlag& typed, Design& design, const KnownNames& known) {
    if (looks_like_sizes(typed.text)) return take_flag(typed, design);
    const auto cases = known.cases();
    if (!cases) return tl::unexpected(cases.error());
    const auto found = find_case(*cases, typed.text);
    if (!found) return fail(ErrorKind::usage, in_file("--case", found.error().message));
    apply(*found, design.case_options);
    return {};
}

/// A case decides how many blocks go in, and blocks that were typed leave the case of a project.
Result<void> settle_case(std::span<const TypedFlag> typed, Design& design) {
    const TypedFlag* const blocks = find_typed(typed, "--blocks");
    const bool in_case = find_typed(typed, "--case") != nullptr;
    if (blocks && in_case && blocks->text != "auto")
        return fail(ErrorKind::usage, say("flag.case_or_blocks"));
    if (blocks && !in_case) design.case_options.inside_mm.reset();
    for (const std::string_view flag : {"--case-play", "--case-radius", "--case-base", "--case-top"})
        if (!design.case_options.inside_mm && find_typed(typed, flag))
            return fail(ErrorKind::usage, say("flag.needs_case"));
    return {};
}

/// "fit.least_rib_mm=5"; what is no JSON is a text.
Result<void> take_set(std::string_view text, Design& design) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string_view::npos)
        return not_what_it_takes("--set", say("takes.set", {{"example", "fit.least_rib_mm=5"}}), text);
    const std::string_view value = text.substr(equals + 1);
    nlohmann::json json = nlohmann::json::parse(value.begin(), value.end(), nullptr, false);
    if (json.is_discarded()) json = value;
    std::string_view path = text.substr(0, equals);
    for (bool more = true; more;) {
        const std::size_t dot = path.rfind('.');
        more = dot != std::string_view::npos;
        json = nlohmann::json{{std::string(path.substr(more ? dot + 1 : 0)), json}};
        path = path.substr(0, more ? dot : 0);
    }
    if (auto problem = read_options(json, design, "--set ")) return fail(ErrorKind::usage, *problem);
    return {};
}

std::vector<Flag> flags_of_the_table(Language language) {
    Design design;
    const OptionList list = all_options(design);
    std::vector<Flag> flags;
    auto shared = list.flags.begin();
    const auto add_shared = [&](std::size_t at) {
        for (; shared != list.flags.end() && shared->at == at; ++shared)
            flags.push_back({std::string(shared->flag), std::string(shared->takes),
                             with_default(shared->help, shared->usual, {}, language)});
    };
    for (std::size_t i = 0; i < list.options.size(); ++i) {
        add_shared(i);
        const Option& option = list.options[i];
        const OptionRow& row = option.row;
        if (row.flag.empty() || list.find_flag(row.flag)) continue;
        flags.push_back({std::string(row.flag), takes_of(option),
                         with_default(row.help, row.usual, text_of(option), language), takes_many(option),
                         repeats(option)});
    }
    add_shared(list.options.size());
    flags.push_back({"--set", "PATH=VALUE",
                     text(say("help.set", {{"example", "workshop.sheets.dxf=false"}}), language), false,
                     true});
    return flags;
}

}  // namespace

bool was_typed(std::span<const TypedFlag> typed, std::string_view flag) {
    return find_typed(typed, flag) != nullptr;
}

const std::vector<Flag>& design_flags(Language language) {
    static const std::vector<Flag> english = flags_of_the_table(Language::english),
                                   japanese = flags_of_the_table(Language::japanese);
    return language == Language::japanese ? japanese : english;
}

KnownNames built_in_names() {
    return {[] { return Result<std::vector<Preset>>(built_in_presets()); },
            [] { return Result<std::vector<KnownCase>>(built_in_cases()); },
            [] { return Result<std::vector<FoamMaterial>>(built_in_foams()); }};
}

Result<void> take_flag(const TypedFlag& typed, Design& design) {
    return take_from(options_of(design), typed);
}

Result<Design> with_flags(std::span<const TypedFlag> typed, Design design, bool from_project,
                          const KnownNames& known) {
    if (auto done = take_preset(typed, design, from_project, known); !done)
        return tl::unexpected(done.error());
    if (auto done = take_foam(typed, design, known); !done) return tl::unexpected(done.error());
    OptionList list = options_of(design);
    for (const Flag& flag : design_flags()) {
        const TypedFlag* const found = find_typed(typed, flag.name);
        if (!found || flag.name == "--preset" || flag.name == "--foam" || flag.name == "--set") continue;
        const auto done = flag.name == "--case"
                              ? take_case(*found, design, known)
                              : take_from(list, flag.repeats ? joined(typed, flag.name) : *found);
        if (!done) return tl::unexpected(done.error());
        if (makes_a_group(list, flag.name)) list = options_of(design);
    }
    if (auto done = settle_case(typed, design); !done) return tl::unexpected(done.error());
    for (const TypedFlag& each : typed)
        if (each.flag == "--set")
            if (auto done = take_set(each.text, design); !done) return tl::unexpected(done.error());
    return design;
}

}  // namespace snug
