#pragma once

#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_supports.h"
#include "snug/fabricate/bricks/linear_program.h"

namespace snug::test {

/// The linear program of Luo et al. as their paper has it: a pull of its own at each contact point of each
/// stud, pressing forces at the corners of every contact rectangle, sideways forces between snapped bricks,
/// presses between neighbours. Column 0 is the largest pull, which is minimised. Slow and plain, and it
/// shares nothing with the library but the weights.
[[nodiscard]] LinearProgram luo_program(const BrickBuild& build, const BrickSupports& supports);

}  // namespace snug::test
