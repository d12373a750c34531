#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace snug {

struct Value;

/// What is said, without its wording: the code of a row of the catalogue (snug/words/words.h) and what goes
/// into the places of its sentence. text() turns it into a sentence of a language.
struct Message {
    std::string code;  ///< empty: the values alone, as they are
    std::vector<Value> values;
};

/// What goes into the place `{name}` of a sentence.
struct Value {
    Value(std::string name_, std::string_view shown) : name(std::move(name_)), content(std::string(shown)) {}
    template <std::integral Count>
    Value(std::string name_, Count count)
        : name(std::move(name_)), content(static_cast<unsigned long long>(count)) {}
    Value(std::string name_, Message part) : name(std::move(name_)), content(std::vector{std::move(part)}) {}
    Value(std::string name_, std::vector<Message> parts)
        : name(std::move(name_)), content(std::move(parts)) {}

    std::string name;
    /// Text that is shown as it is in every language, such as a formatted number, a file's name or an option;
    /// how many of something there are (0 or more), which also chooses between singular and plural; or other
    /// messages, none to many of them.
    std::variant<std::string, unsigned long long, std::vector<Message>> content;
};

/// `code` stands in the catalogue, and the names of the values are those of its sentences.
[[nodiscard]] inline Message say(std::string code, std::vector<Value> values = {}) {
    return {std::move(code), std::move(values)};
}

/// A name, a number or the like, which are the same in every language.
[[nodiscard]] inline Message as_it_is(std::string_view shown) {
    return {{}, {{std::string(), shown}}};
}

}  // namespace snug
