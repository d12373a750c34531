#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snug {

/// How wide a line of UTF-8 text is in Helvetica (its published character widths; Latin letters beyond ASCII
/// count as an average one) and, for letters that it lacks, in a font whose letters are as wide as they are
/// high.
[[nodiscard]] double text_width(std::string_view text, double height_mm, bool bold = false);

/// The text in lines no wider than `width_mm`, each as full as it can be: broken at spaces and
/// between wide characters (snug/base/wide_text.h), a word that is wider anywhere.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text, double width_mm, double height_mm,
                                                bool bold = false);

}  // namespace snug
