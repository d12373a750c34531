#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/color.h"
#include "snug/words/words.h"

// Small pieces of SVG text that drawings are made of.

namespace snug {

/// "#4084d6"
[[nodiscard]] std::string hex(Color color);
/// From `a` (share 0) to `b` (share 1).
[[nodiscard]] Color mixed(Color a, Color b, double share);

/// What ends a list of font families: those that have the letters of a language and Helvetica lacks, then
/// any. Begins with a comma.
[[nodiscard]] std::string more_fonts(Language language);

/// Text for an XML element or attribute: markup escaped; what is not UTF-8, or a character that XML forbids,
/// becomes a replacement character.
[[nodiscard]] std::string xml_text(std::string_view text);

/// The lines that `text` (UTF-8) fills when none is longer than `longest` characters, of which wide ones
/// count as two: broken at spaces and between wide characters (snug/base/wide_text.h), longer words anywhere,
/// and as even as that many lines can be. At most `most_lines`; the last one ends in an ellipsis if more
/// would follow.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t longest,
                                               std::size_t most_lines);

}  // namespace snug
