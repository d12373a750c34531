#include "snug/fabricate/bricks/brick_statics.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "snug/fabricate/bricks/brick_forces.h"
#include "snug/fabricate/bricks/brick_springs.h"

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

/// A half that pulls at its studs with so many grams a point at most.
BrickStrength pulled(BrickLoad load, double grip, double capacity_n) {
    BrickStrength strength;
    strength.load = load;
    const double newtons = grip < kNoPull ? 0 : grip * kNewtonsPerGram;
    strength.used = newtons / capacity_n;
    strength.left_n = capacity_n - newtons;
    if (strength.used > 1) strength.outcome = StrengthOutcome::overloaded;
    return strength;
}

/// A half that uses no more than this of what its studs hold need not be known better.
constexpr double kHoldsEasily = 0.1;

/// What some forces, found quickly, say: a half that holds with them, or nothing.
Result<std::optional<BrickStrength>> sprung(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                            const BrickSupports& supports, double capacity_n,
                                            const Progress& progress) {
    const BrickForces forces = brick_forces(build, joints, supports, ForceModel::upright);
    const auto found =
        spring_forces(build, joints, supports, forces, kHoldsEasily * capacity_n / kNewtonsPerGram, progress);
    if (!found) return tl::unexpected(found.error());
    const std::vector<double>& x = *found;
    if (x.empty()) return std::nullopt;
    BrickStrength strength = pulled(supports.load, x.front(), capacity_n);
    if (!strength.holds()) return std::nullopt;
    strength.exact = strength.used == 0;
    if (strength.used > 0) {
        const std::vector<double> pulls = joint_pulls(build, joints, forces, x);
        strength.weakest = joints[std::max_element(pulls.begin(), pulls.end()) - pulls.begin()];
    }
    return strength;
}

/// What the solver says.
Result<BrickStrength> solved(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                             const BrickSupports& supports, double capacity_n, const LpSolver& solve,
                             const Progress& progress) {
    BrickStrength strength;
    strength.load = supports.load;
    const BrickForces forces = brick_forces(build, joints, supports, ForceModel::full);
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
    strength = pulled(supports.load, solution->x.front(), capacity_n);
    if (strength.used > 0)
        strength.weakest = joints[weakest_joint(build, joints, supports, forces, *solution)];
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
    const auto bricks = static_cast<int>(build.bricks.size());
    if (bricks > kMostBricksChecked) return ended(StrengthOutcome::too_large);
    const bool few = bricks <= kFewBricks;
    const double half_way = few ? 0 : 0.3;
    if (!solve || !few) {
        auto found = sprung(build, joints, supports, capacity_n, part_of(progress, 0, half_way));
        if (!found) return tl::unexpected(found.error());
        if (*found) return **found;
    }
    if (!solve) return ended(StrengthOutcome::no_solver);
    if (bricks > kMostBricksSolved) return ended(StrengthOutcome::too_large);
    return solved(build, joints, supports, capacity_n, solve, part_of(progress, half_way, 1));
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
