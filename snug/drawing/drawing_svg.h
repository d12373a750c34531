#pragma once

#include <string>

#include "snug/drawing/drawing.h"

namespace snug {

/// The drawing at true size: one unit is one mm. Items of one layer that follow each other share a group,
/// which has the layer's name as Inkscape's label and, with a number where it comes again, as its id.
[[nodiscard]] std::string drawing_svg(const Drawing& drawing);

}  // namespace snug
