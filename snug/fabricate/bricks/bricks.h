#pragma once

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/bricks/linear_program.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// Both halves built of bricks, cavity up:
///   bricks/foams.mpd         LDraw: a model of each half, a step of each layer
///   bricks/parts.csv         how many of each piece and colour
///   bricks/wanted.xml        the same as a wanted list for BrickLink
///   bricks-plan.pdf          what is needed, then every layer with the pieces that it adds
/// Fails (kind usage) for options out of range, block sizes that no brick has, a family that cannot fill or
/// span the foam, and a stock that does not suffice. `solve` checks how firmly the build holds.
[[nodiscard]] Result<WorkshopPack> brick_pack(const FoamDesign& design, const WorkshopOptions& options,
                                              const LpSolver& solve, const Progress& progress);

}  // namespace snug
