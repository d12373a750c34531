#pragma once

#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_forces.h"
#include "snug/fabricate/bricks/brick_supports.h"

namespace snug {

/// Forces in equilibrium without a linear program: bricks that rest on springs, one under each contact
/// rectangle, come to rest in some place, and what their springs then carry balances every brick. Any such
/// forces prove that the build holds if no joint pulls more than it can (the safe theorem of limit analysis),
/// so `x[0]` is never less than the least grip of the same program, only found in milliseconds. Springs of
/// joints that pull most are then made softer, some times over, which spreads the load.
///
/// A solution of equilibrium(build, supports, forces) for ForceModel::upright, rows met to about a millionth
/// of a gram; empty where none was found, which says nothing. The search ends early with a grip of `enough`
/// grams or less. Fails with kind `cancelled` alone.
[[nodiscard]] Result<std::vector<double>> spring_forces(const BrickBuild& build,
                                                        const std::vector<BrickJoint>& joints,
                                                        const BrickSupports& supports,
                                                        const BrickForces& forces, double enough = 0,
                                                        const Progress& progress = {});

}  // namespace snug
