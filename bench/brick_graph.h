#pragma once

#include "snug/fabricate/bricks/brick_build.h"

namespace snug::bench {

/// How many pieces a build falls into: bricks that studs tie together are one.
[[nodiscard]] int piece_count(const BrickBuild& build);

/// Bricks without which what they tie together falls into more pieces (Testuz, Schwartzburg and Pauly,
/// "Automatic Generation of Constructable Brick Sculptures", Eurographics 2013).
[[nodiscard]] int articulation_bricks(const BrickBuild& build);

}  // namespace snug::bench
