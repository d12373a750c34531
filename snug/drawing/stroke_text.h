#pragma once

#include <string_view>
#include <vector>

#include "snug/drawing/drawing.h"

namespace snug {

/// Text as open lines for cutters and engravers: capitals, digits, - + . / and spaces; small letters become
/// small capitals, what else there is is left out. `at` lies on the baseline where the anchor says; a capital
/// is 0.7 of the height. `turn_deg`: 0, 90, 180 or 270, clockwise as seen by the reader.
[[nodiscard]] std::vector<std::vector<Vec2d>> stroke_text(std::string_view text, Vec2d at, double height_mm,
                                                          TextAnchor anchor = TextAnchor::start,
                                                          double turn_deg = 0);

}  // namespace snug
