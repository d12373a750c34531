#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_supports.h"
#include "snug/fabricate/bricks/linear_program.h"

// How firmly a half of bricks holds together: see brick_forces.h for the method.

namespace snug {

/// A build of so many bricks at most is always given to the solver, which takes some tenths of a second and
/// gives the exact figures. With more bricks it is asked only where brick_springs.h finds no forces that
/// hold, and above kMostBricksSolved not even then: its time grows faster than the square of their number, to
/// minutes. Above kMostBricksChecked the springs take long, too. (docs/benchmarks.md)
constexpr int kFewBricks = 300, kMostBricksSolved = 2000, kMostBricksChecked = 8000;

enum class StrengthOutcome {
    holds,
    overloaded,  ///< in equilibrium only where some stud holds more than it can
    loose,       ///< some bricks are tied to no support
    falls,       ///< no forces keep it in equilibrium: it tips over, or apart
    no_solver,   ///< not checked: this build of Snug has no solver
    too_large,   ///< not checked: bricks above the limits
    unsolved,    ///< not checked: the solver gave up
};

/// One half in one load case.
struct BrickStrength {
    BrickLoad load = BrickLoad::standing;
    StrengthOutcome outcome = StrengthOutcome::holds;
    /// The largest pull at a contact point over what it can hold; over 1 where it is overloaded. 0 for all
    /// outcomes but `holds` and `overloaded`.
    double used = 0;
    bool exact = true;  ///< the least that any forces could do with; false: some forces do with it, others
                        ///< may do with less
    double left_n = 0;  ///< newtons: the smallest remaining capacity of a contact point, (1 - used) capacity
    std::optional<BrickJoint> weakest;  ///< the joint that bears most; none where no stud pulls
    std::vector<int> loose;             ///< the bricks that are, by number

    [[nodiscard]] bool checked() const { return outcome < StrengthOutcome::no_solver; }
    [[nodiscard]] bool holds() const { return outcome == StrengthOutcome::holds; }
};

constexpr std::array kBrickLoads{BrickLoad::standing, BrickLoad::lifted, BrickLoad::turned};

/// One load case. In this order: bricks that are tied to nothing; a half that rests throughout; forces found
/// with springs; the linear program. All but the last need no solver.
/// `capacity_n`: newtons that a contact point of a stud holds, above 0. Fails with kind `cancelled` alone.
[[nodiscard]] Result<BrickStrength> brick_strength(const BrickBuild& build, BrickLoad load, double capacity_n,
                                                   const LpSolver& solve, const Progress& progress = {});

/// All load cases, in the order of kBrickLoads.
using BrickStatics = std::array<BrickStrength, kBrickLoads.size()>;
[[nodiscard]] Result<BrickStatics> brick_statics(const BrickBuild& build, double capacity_n,
                                                 const LpSolver& solve, const Progress& progress = {});

}  // namespace snug
