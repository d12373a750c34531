#include "snug/base/message.h"

#include <utility>

namespace snug {

Message::Message() = default;
Message::Message(std::string_view code_, std::vector<Value> values_)
    : code(code_), values(std::move(values_)) {}
Message::Message(const Message&) = default;
Message::Message(Message&&) noexcept = default;
Message& Message::operator=(const Message&) = default;
Message& Message::operator=(Message&&) noexcept = default;
Message::~Message() = default;

Value::Value(std::string_view name_, Content content_) : name(name_), content(std::move(content_)) {}
Value::Value(std::string_view name_, std::string_view shown) : Value(name_, Content(std::string(shown))) {}
Value::Value(std::string_view name_, const char* shown) : Value(name_, Content(std::string(shown))) {}
Value::Value(std::string_view name_, const std::string& shown) : Value(name_, Content(shown)) {}
Value::Value(std::string_view name_, Message part) : name(name_) {
    content.emplace<std::vector<Message>>().push_back(std::move(part));
}
Value::Value(std::string_view name_, std::vector<Message> parts) : Value(name_, Content(std::move(parts))) {}
Value::Value(const Value&) = default;
Value::Value(Value&&) noexcept = default;
Value& Value::operator=(const Value&) = default;
Value& Value::operator=(Value&&) noexcept = default;
Value::~Value() = default;

Message say(std::string_view code) {
    return {code, {}};
}

Message say(std::string_view code, std::initializer_list<Value> values) {
    return {code, values};
}

Message say(std::string_view code, std::vector<Value> values) {
    return {code, std::move(values)};
}

Message as_it_is(std::string_view shown) {
    return {{}, {{std::string_view(), shown}}};
}

}  // namespace snug
