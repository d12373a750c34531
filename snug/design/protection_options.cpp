#include "snug/design/protection_options.h"

#include <string_view>
#include <vector>

#include "snug/base/text.h"
#include "snug/design/option_list.h"
#include "snug/design/option_text.h"

namespace snug {
namespace {

/// A number, one of the words, or "none", into the one of two options that it is for.
template <class Word>
Result<void> take_number_or_word(std::string_view flag, std::string_view example, std::string_view text,
                                 std::optional<double>& number, std::optional<Word>& word) {
    const auto typed = typed_number(text);
    const auto named = value_named<Word>(text);
    if (!typed && !named && text != "none")
        return not_what_it_takes(
            flag,
            say("takes.number_or_word", {{"example", example}, {"words", each_as_it_is(names_of<Word>())}}),
            text);
    number = typed;
    word = named;
    return {};
}

template <class Word>
std::optional<std::string> say_number_or_word(const std::optional<double>& number,
                                              const std::optional<Word>& word) {
    if (number) return exact(*number);
    return word ? std::string(name_of(*word)) : std::string("none");
}

}  // namespace

SharedFlag<ProtectionOptions> drop_height_flag() {
    return {
        .flag = "--drop-height",
        .takes = "MM|RULE",
        .help = {"From which height the closed case falls: mm, or by the packed mass after ista-1a, ista-2a, "
                 "ista-3a, d4169-2 or handling",
                 "閉じたケースの落下高さ：mm、または梱包後の質量から "
                 "ista-1a、ista-2a、ista-3a、d4169-2、handling の規格により決めます"},
        .take =
            [](std::string_view text, ProtectionOptions& protection) {
                return take_number_or_word("--drop-height", "760", text, protection.height_mm,
                                           protection.rule);
            },
        .say =
            [](const ProtectionOptions& protection) {
                return say_number_or_word(protection.height_mm, protection.rule);
            },
        .usual = {"none: no drop is looked at", "なし：落下を計算しません"}};
}

SharedFlag<ProtectionOptions> fragility_flag() {
    return {
        .flag = "--fragility",
        .takes = "G|CLASS",
        .help = {"The greatest shock that the object bears: G, or by its class museum, extremely-fragile, "
                 "very-delicate, delicate, moderately-delicate, moderately-rugged or rugged",
                 "対象物が耐える最大の衝撃：G、または区分 museum、extremely-fragile、very-delicate、delicate"
                 "、moderately-delicate、moderately-rugged、rugged"},
        .take =
            [](std::string_view text, ProtectionOptions& protection) {
                return take_number_or_word("--fragility", "40", text, protection.fragility_g,
                                           protection.fragility);
            },
        .say =
            [](const ProtectionOptions& protection) {
                return say_number_or_word(protection.fragility_g, protection.fragility);
            },
        .usual = {"none: shocks are told, not judged", "なし：衝撃を示すだけで判定しません"}};
}

std::optional<OptionProblem> problem_of(const ProtectionOptions& options) {
    if (auto found = out_of_range(options)) return found;
    if (auto wrong = problem_of(options.zones)) return OptionProblem{"zones", *wrong};
    if (options.height_mm && options.rule) return OptionProblem{"rule", say("protection.height_or_rule")};
    if (options.fragility_g && options.fragility)
        return OptionProblem{"fragility", say("protection.g_or_class")};
    if (options.foam)
        if (auto found = problem_of(*options.foam)) return found->within("foam");
    return {};
}

}  // namespace snug
