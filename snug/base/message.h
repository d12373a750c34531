#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Sentences are made in hundreds of places, so that what makes and destroys them is compiled once
// (message.cpp) instead of into each.

namespace snug {

struct Value;

/// What is said, without its wording: the code of a row of the catalogue (snug/words/words.h) and what goes
/// into the places of its sentence. text() turns it into a sentence of a language.
struct Message {
    Message();
    Message(std::string_view code_, std::vector<Value> values_);
    Message(const Message&);
    Message(Message&&) noexcept;
    Message& operator=(const Message&);
    Message& operator=(Message&&) noexcept;
    ~Message();

    std::string code;  ///< empty: the values alone, as they are
    std::vector<Value> values;
};

/// What goes into the place `{name}` of a sentence.
struct Value {
    using Content = std::variant<std::string, unsigned long long, std::vector<Message>>;

    Value(std::string_view name_, std::string_view shown);
    Value(std::string_view name_, const char* shown);
    Value(std::string_view name_, const std::string& shown);
    template <std::integral Count>
    Value(std::string_view name_, Count count)
        : Value(name_, Content(static_cast<unsigned long long>(count))) {}
    Value(std::string_view name_, Message part);
    Value(std::string_view name_, std::vector<Message> parts);
    Value(std::string_view name_, Content content_);
    Value(const Value&);
    Value(Value&&) noexcept;
    Value& operator=(const Value&);
    Value& operator=(Value&&) noexcept;
    ~Value();

    std::string name;
    /// Text that is shown as it is in every language, such as a formatted number, a file's name or an option;
    /// how many of something there are (0 or more), which also chooses between singular and plural; or other
    /// messages, none to many of them.
    Content content;
};

/// `code` stands in the catalogue, and the names of the values are those of its sentences.
[[nodiscard]] Message say(std::string_view code);
[[nodiscard]] Message say(std::string_view code, std::initializer_list<Value> values);
[[nodiscard]] Message say(std::string_view code, std::vector<Value> values);

/// A name, a number or the like, which are the same in every language.
[[nodiscard]] Message as_it_is(std::string_view shown);

}  // namespace snug
