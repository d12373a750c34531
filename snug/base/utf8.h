#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "snug/base/bytes.h"

namespace snug {

/// Appends a character; what is no character of Unicode becomes U+FFFD.
void append_utf8(char32_t character, std::string& text);

/// Bytes of the character at the front of `text`, which is not empty; 0 where there is none.
[[nodiscard]] std::size_t character_bytes(std::string_view text);

/// Whether every byte belongs to a character: no overlong form, no half of a pair, nothing beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view text);

/// The text as UTF-8 if it is UTF-16 of either order: by its byte order mark, or because its first character
/// is ASCII. None otherwise. Halves of pairs that stand alone become U+FFFD, and so does half a character at
/// the end. The mark is no part of the text.
[[nodiscard]] std::optional<std::string> from_utf16(Bytes text);

}  // namespace snug
