#pragma once

#include <string>
#include <string_view>

namespace snug {

constexpr bool is_xml_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Without the spaces around it.
[[nodiscard]] std::string_view without_xml_spaces(std::string_view text);

/// Replaces the five entities of XML and character references. False where another entity or a damaged one
/// stands in the text: nothing else is ever expanded.
[[nodiscard]] bool expand_xml(std::string_view text, std::string& expanded);

}  // namespace snug
