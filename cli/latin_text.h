#pragma once

#include <string>
#include <string_view>

namespace snug::cli {

/// UTF-8 as Windows-1252, what PDF's built-in fonts know; a question mark for each letter that it lacks.
[[nodiscard]] std::string latin_text(std::string_view utf8);

}  // namespace snug::cli
