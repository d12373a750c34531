#pragma once

#include "snug/fabricate/bricks/linear_program.h"

namespace snug {

/// Linear programs by CLP of COIN-OR: primal simplex on one thread, so the same answer in every run. Says
/// nothing. The progress is an estimate, since nobody knows how many steps the simplex will take. Fails with
/// kind `cancelled` where the progress says so, and with kind `usage` where CLP gives up (a program without
/// a least cost, or numbers that it cannot handle).
[[nodiscard]] LpSolver clp_solver();

}  // namespace snug
