#pragma once

#include <vector>

#include "snug/base/result.h"
#include "snug/drawing/drawing.h"

namespace snug {

/// A drawing at true size on as many sheets of paper as it takes, upright or across, whichever takes fewer.
/// The tiles butt: no strip is printed twice. Each page names its tile, shows where it lies among the others,
/// a bar of 100 mm, and crosses on the edges that it shares, which its neighbour has too. Pages that would
/// hold nothing, or only lines of the layer `grid`, are left out. A drawing that fits one page stays whole.
/// Fails with kind `usage` where the paper has no room within its margins.
[[nodiscard]] Result<std::vector<Drawing>> tiled(const Drawing& drawing, Vec2d paper_mm);

/// The page before the tiles: what to tell the printer, a square of 100 x 100 mm to measure, how to join.
[[nodiscard]] Drawing print_check_page(Vec2d paper_mm, const std::string& title,
                                       Language language = Language::english);

}  // namespace snug
