#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace snug::cli {

/// The byte of a character in Windows-1252, which is what PDF's built-in fonts know; none where that lacks
/// it.
[[nodiscard]] std::optional<char> latin_letter(char32_t character);

/// Whether Windows-1252 has every letter of a text.
[[nodiscard]] bool is_latin(std::string_view utf8);

/// UTF-8 as Windows-1252; a question mark for each letter that it lacks.
[[nodiscard]] std::string latin_text(std::string_view utf8);

}  // namespace snug::cli
