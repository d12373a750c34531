#pragma once

#include <cstddef>
#include <string_view>

// Text whose characters are not all of one width, such as Japanese, which stands without blanks.

namespace snug {

/// The character at the front of the text, which is not empty, and its bytes: a byte that belongs to none
/// stands for itself as U+FFFD.
struct FirstCharacter {
    char32_t character;
    std::size_t bytes;
};
[[nodiscard]] FirstCharacter first_character(std::string_view text);

/// Whether a character is as wide as it is high (East Asian wide and fullwidth characters, by their blocks).
[[nodiscard]] bool is_wide(char32_t character);

/// What must stay in one line at the front of a text: all up to a blank, or to a place between two characters
/// of which one is wide; though no line begins with a mark that closes, nor ends with one that opens. Empty
/// where the text begins with a blank.
[[nodiscard]] std::string_view unbroken(std::string_view text);

}  // namespace snug
