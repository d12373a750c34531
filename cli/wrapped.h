#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace snug::cli {

/// How many columns of a terminal a text takes: two for each wide character, such as those of Japanese.
[[nodiscard]] std::size_t columns_of(std::string_view text);

/// The text with blanks behind it up to `columns` columns.
[[nodiscard]] std::string padded(std::string_view text, std::size_t columns);

/// Breaks a sentence into lines of about 90 columns, the later ones indented: at blanks, and between wide
/// characters, though not before a mark that closes.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent);

}  // namespace snug::cli
