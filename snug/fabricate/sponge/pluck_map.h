#pragma once

#include "snug/drawing/drawing.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/sponge/pluck_plan.h"

namespace snug {

/// A layer's map at true size, with a margin for row and column names. Layers of the drawing: `pluck` holds
/// a rectangle for each run of blocks to pluck within a row, `grid`, `edge` (the foam's outline, BACK thick,
/// one corner cut off), `notes`.
[[nodiscard]] Drawing pluck_map(const PluckPlan& plan, const LayerRun& run, const FoamDesign& design);

/// The fit-test piece at true size, drawn like a layer's map and called `name`: the layer `ring` holds what
/// stays.
[[nodiscard]] Drawing fit_test_map(const FitTest& test, const Message& name, const FoamDesign& design);

/// How many blocks deep each column goes, fitted on one page of upright paper, which may lie across: shades,
/// and numbers where they can be read.
[[nodiscard]] Drawing pluck_overview(const PluckPlan& plan, Vec2d paper, const FoamDesign& design);

/// Whether the overview on this paper has room for its numbers.
[[nodiscard]] bool overview_has_numbers(const PluckPlan& plan, Vec2d paper);

}  // namespace snug
