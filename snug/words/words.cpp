#include "snug/words/words.h"

#include <algorithm>
#include <cassert>

#include "snug/base/text.h"
#include "snug/words/catalogue.h"

namespace snug {
namespace {

struct Separators {
    std::string_view comma, semicolon, last, any;
};

const Separators& separators(Language language) {
    static constexpr Separators kEnglish{", ", "; ", " and ", " or "}, kJapanese{"、", "、", "と", "、"};
    return language == Language::japanese ? kJapanese : kEnglish;
}

std::string joined(const std::vector<Message>& parts, std::string_view between, std::string_view last,
                   Language language) {
    std::string joined;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) joined += i + 1 == parts.size() ? last : between;
        joined += text(parts[i], language);
    }
    return joined;
}

/// `how`: what stands behind the name in the place, as the catalogue explains.
std::string shown(const Value& value, std::string_view how, Language language) {
    if (const auto* as_it_is = std::get_if<std::string>(&value.content)) return *as_it_is;
    if (const auto* count = std::get_if<unsigned long long>(&value.content)) {
        if (how.empty()) return grouped(*count);
        how.remove_prefix(1);
        const std::size_t bar = how.find('|');
        return std::string(*count == 1 ? how.substr(0, bar) : how.substr(bar + 1));
    }
    const Separators& with = separators(language);
    const std::string_view between = how.empty() ? "" : how == ";" ? with.semicolon : with.comma;
    const std::string_view last = how == "&" ? with.last : how == "/" ? with.any : between;
    return joined(std::get<std::vector<Message>>(value.content), between, last, language);
}

/// What goes into a place, without its braces.
std::string filled(std::string_view place, const Message& message, Language language) {
    const std::size_t end = std::min(place.find_first_of("|,;&/"), place.size());
    for (const Value& value : message.values)
        if (value.name == place.substr(0, end)) return shown(value, place.substr(end), language);
    assert(false && "a value of the sentence is missing");
    return std::string(place);
}

}  // namespace

std::string_view language_name(Language language) {
    return language == Language::japanese ? "ja" : "en";
}

std::optional<Language> language_from_name(std::string_view name) {
    for (const Language language : {Language::english, Language::japanese})
        if (language_name(language) == name) return language;
    return {};
}

std::string text(const Message& message, Language language) {
    std::string sentence;
    if (message.code.empty()) {
        for (const Value& value : message.values) sentence += shown(value, {}, language);
        return sentence;
    }
    const Wording* row = wording(message.code);
    assert(row && "the catalogue has no such code");
    if (!row) return message.code;
    std::string_view rest = language == Language::japanese ? row->japanese : row->english;
    while (!rest.empty()) {
        const std::size_t open = std::min(rest.find('{'), rest.size());
        sentence += rest.substr(0, open);
        rest.remove_prefix(open);
        if (rest.empty()) break;
        const std::size_t close = rest.find('}');
        sentence += filled(rest.substr(1, close - 1), message, language);
        rest.remove_prefix(close + 1);
    }
    return sentence;
}

}  // namespace snug
