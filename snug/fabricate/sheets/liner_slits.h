#pragma once

#include <vector>

#include "snug/base/vec2.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// Where a knife slits the uppermost sheet of a piece, not through it, for the edges of a liner that is
/// tucked in: lines around the cavities, at this distance from them along rows and along columns, wherever
/// the sheet has room for them. Cavities that are nearer to each other share one. mm from the stack's upper
/// left corner.
[[nodiscard]] std::vector<std::vector<Vec2d>> liner_slits(const SheetStack& stack, double away_mm);

}  // namespace snug
