#include "snug/design/hand_edit.h"

#include "snug/base/text.h"
#include "snug/design/clearance.h"
#include "snug/design/option_text.h"

namespace snug {
namespace {

constexpr std::string_view kLower = "lower", kUpper = "upper", kMiddle = "middle-", kUnder = "under";
constexpr int kMostOfColumn = 4096;

std::optional<HandEdit> typed_edit(std::string_view text) {
    const auto words = words_between(text, ':');
    if (words.size() != 4 && !(words.size() == 5 && words[4] == kUnder)) return {};
    const auto j = typed_integer(words[1]), k = typed_integer(words[2]), blocks = typed_integer(words[3]);
    if (!j || !k || !blocks) return {};
    return HandEdit{std::string(words[0]), *j, *k, *blocks, words.size() == 5};
}

std::string text_of(const HandEdit& edit) {
    std::string text = edit.piece;
    for (const int number : {edit.j, edit.k, edit.blocks}) text += ":" + std::to_string(number);
    return text + (edit.under ? ":" + std::string(kUnder) : "");
}

std::optional<Message> problem_of(const HandEdit& edit, const std::string& number) {
    if (edit.piece != kLower && edit.piece != kUpper && !middle_number(edit))
        return say("edit.piece", {{"edit", number}, {"piece", quoted(edit.piece)}});
    if (edit.under && !middle_number(edit)) return say("edit.under", {{"edit", number}});
    const auto in_column = [](int value) { return value >= 0 && value < kMostOfColumn; };
    if (!in_column(edit.j) || !in_column(edit.k)) return say("edit.column", {{"edit", number}});
    if (edit.blocks == 0 || edit.blocks > kMostOfColumn || edit.blocks < -kMostOfColumn)
        return say("edit.blocks", {{"edit", number}});
    return {};
}

}  // namespace

std::optional<HandEdits> typed_edits(std::string_view text) {
    HandEdits edits;
    for (const std::string_view word : words_between(text, ',')) {
        auto edit = typed_edit(word);
        if (!edit) return {};
        edits.push_back(std::move(*edit));
    }
    if (edits.empty()) return {};
    return edits;
}

std::optional<std::string> text_of(const HandEdits& edits) {
    std::optional<std::string> text;
    for (const HandEdit& edit : edits) text = text ? *text + "," + text_of(edit) : text_of(edit);
    return text;
}

std::optional<int> middle_number(const HandEdit& edit) {
    const std::string_view piece = edit.piece;
    if (!piece.starts_with(kMiddle)) return {};
    const auto number = typed_integer(piece.substr(kMiddle.size()));
    if (!number || *number < 1 || std::to_string(*number) != piece.substr(kMiddle.size())) return {};
    return number;
}

std::optional<Message> problem_of(const HandEdits& edits) {
    if (edits.size() > kMostEdits) return say("edit.many", {{"most", std::to_string(kMostEdits)}});
    for (std::size_t i = 0; i < edits.size(); ++i)
        if (auto problem = problem_of(edits[i], std::to_string(i + 1))) return problem;
    return {};
}

}  // namespace snug
