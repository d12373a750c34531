#pragma once

#include <span>
#include <string>

#include "snug/fabricate/bricks/brick_build.h"

namespace snug {

/// A half and the colour it is built in.
struct ColoredBuild {
    const BrickBuild* build = nullptr;
    const BrickColor* color = nullptr;
};

/// One LDraw file (MPD, ldraw.org/article/47) of both halves: a model with the lid behind the lower half as
/// if it were turned over its BACK edge, then a model of each half, cavity up, in the order of building with
/// a STEP after each course. Lines end in CR LF. Lengths in LDraw units of 0.4 mm, -y up.
[[nodiscard]] std::string ldraw_file(std::span<const ColoredBuild> halves, const std::string& object_name);

}  // namespace snug
