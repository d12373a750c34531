#include "snug/fabricate/brick_statics.h"

#include <algorithm>
#include <utility>

#include "snug/fabricate/brick_forces.h"

namespace snug {
namespace {

/// Grams below which a pull is the solver's rounding.
constexpr double kNoPull = 1e-5;

/// The joint that gives first: the one with the largest part in the collapse, or, of a solver that tells no
/// prices, the first that pulls most.
int weakest_joint(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                  const BrickSupports& supports, const BrickForces& forces, const LpSolution& solution) {
    const std::vector<double> shares = solution.price.empty()
                                           ? joint_pulls(build, joints, forces, solution.x)
                                           : joint_parts(build, supports, forces, solution.price);
    return static_cast<int>(std::max_element(shares.begin(), shares.end()) - shares.begin());
}

/// What the solver says of one model.
Result<BrickStrength> solved(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                             const BrickSupports& supports, ForceModel model, double capacity_n,
                             const LpSolver& solve, const Progress& progress) {
    BrickStrength strength;
    strength.load = supports.load;
    const BrickForces forces = brick_forces(build, joints, supports, model);
    const auto solution = solve(equilibrium(build, supports, forces), progress);
    if (!solution) {
        if (solution.error().kind == ErrorKind::cancelled) return tl::unexpected(solution.error());
        strength.outcome = StrengthOutcome::unsolved;
        return strength;
    }
    if (!solution->feasible) {
        strength.outcome = StrengthOutcome::falls;
        return strength;
    }
    const double grip = solution->x.front() < kNoPull ? 0 : solution->x.front();
    strength.used = grip * kNewtonsPerGram / capacity_n;
    strength.left_n = capacity_n - grip * kNewtonsPerGram;
    if (strength.used > 1) strength.outcome = StrengthOutcome::overloaded;
    if (grip > 0) strength.weakest = joints[weakest_joint(build, joints, supports, forces, *solution)];
    return strength;
}

Result<BrickStrength> strength_in(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                  BrickLoad load, double capacity_n, const LpSolver& solve,
                                  const Progress& progress) {
    const BrickSupports supports = brick_supports(build, joints, load);
    BrickStrength strength;
    strength.load = load;
    strength.loose = loose_bricks(supports, joints);
    const auto ended = [&](StrengthOutcome outcome) {
        strength.outcome = outcome;
        return strength;
    };
    if (!strength.loose.empty()) return ended(StrengthOutcome::loose);
    if (rests_throughout(build, joints, supports)) {
        strength.left_n = capacity_n;
        return strength;
    }
    if (!solve) return ended(StrengthOutcome::no_solver);
    if (static_cast<int>(build.bricks.size()) > kMostBricksChecked) return ended(StrengthOutcome::too_large);

    // The small model first: what it can hold, holds. Only the rest asks whether bricks that lean on each
    // other do better.
    constexpr double kShareOfUpright = 0.3;
    auto upright = solved(build, joints, supports, ForceModel::upright, capacity_n, solve,
                          part_of(progress, 0, kShareOfUpright));
    if (!upright || upright->holds()) return upright;
    auto full = solved(build, joints, supports, ForceModel::full, capacity_n, solve,
                       part_of(progress, kShareOfUpright, 1));
    return full;
}

}  // namespace

Result<BrickStrength> brick_strength(const BrickBuild& build, BrickLoad load, double capacity_n,
                                     const LpSolver& solve, const Progress& progress) {
    return strength_in(build, brick_joints(build), load, capacity_n, solve, progress);
}

Result<BrickStatics> brick_statics(const BrickBuild& build, double capacity_n, const LpSolver& solve,
                                   const Progress& progress) {
    const std::vector<BrickJoint> joints = brick_joints(build);
    BrickStatics statics;
    for (std::size_t i = 0; i < statics.size(); ++i) {
        const double begin = static_cast<double>(i) / static_cast<double>(statics.size());
        const double end = static_cast<double>(i + 1) / static_cast<double>(statics.size());
        auto strength =
            strength_in(build, joints, kBrickLoads[i], capacity_n, solve, part_of(progress, begin, end));
        if (!strength) return tl::unexpected(strength.error());
        statics[i] = std::move(*strength);
    }
    return statics;
}

}  // namespace snug
