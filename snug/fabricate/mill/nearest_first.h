#pragma once

#include <cstddef>
#include <vector>

#include "snug/fabricate/mill/mill_passes.h"

namespace snug {

/// The lines in an order in which each begins near where the one before ends, turned round where that is
/// nearer. Looks within `reach_mm` first, then further and further. The same order for the same lines.
[[nodiscard]] std::vector<CutLine> nearest_first(const std::vector<CutLine>& lines, Vec2d start,
                                                 double reach_mm);

/// The same order as numbers of the lines, none of them turned round.
[[nodiscard]] std::vector<std::size_t> nearest_first_order(const std::vector<CutLine>& lines, Vec2d start,
                                                           double reach_mm);

}  // namespace snug
