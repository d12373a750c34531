#include "snug/fabricate/bricks/brick_statics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "snug/fabricate/bricks/brick_forces.h"
#include "snug/fabricate/bricks/brick_springs.h"
#include "snug/fabricate/bricks/brick_statics_report.h"

#include "bench/random_merge.h"
#include "cli/clp_solver.h"
#include "tests/support/luo_statics.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

constexpr double kCapacity = 0.7;
constexpr double kTolerance = 1e-4;  // grams

BrickBuild built(int rows, int columns, std::vector<Brick> bricks) {
    return {Half::lower, rows, columns, std::move(bricks)};
}

/// Layers of bricks, numbered from the floor.
Brick brick(int layer, int row, int column, int rows, int columns) {
    return {BrickKind::brick, row, column, rows, columns, kPlatesInBrick * layer};
}

BrickStrength strength(const BrickBuild& build, BrickLoad load, double capacity = kCapacity) {
    return *brick_strength(build, load, capacity, clp_solver());
}

/// The least grip in grams, of one model; negative: no equilibrium.
double grip_of(const BrickBuild& build, const BrickSupports& supports, ForceModel model) {
    const BrickForces forces = brick_forces(build, brick_joints(build), supports, model);
    const auto solution = *clp_solver()(equilibrium(build, supports, forces), {});
    return solution.feasible ? solution.x.front() : -1;
}

/// A bowl or anything else: foam everywhere, random heights, the rim full.
bench::BrickHeights random_heights(Random& random) {
    const int rows = random.integer(3, 7), columns = random.integer(3, 7), layers = random.integer(2, 4);
    bench::BrickHeights heights(rows, columns, static_cast<std::uint16_t>(layers));
    for (int row = 1; row + 1 < rows; ++row)
        for (int column = 1; column + 1 < columns; ++column)
            heights(row, column) = static_cast<std::uint16_t>(random.integer(1, layers));
    return heights;
}

BrickBuild random_build(Random& random) {
    // One after the other: compilers evaluate arguments in different orders.
    const auto heights = random_heights(random);
    return bench::random_merge(heights, {BrickKind::brick, bench::luo_family(), random.bits()});
}

/// More bricks than are always given to the solver.
BrickBuild large_bowl() {
    const int rows = 32, columns = 24, layers = 9;
    bench::BrickHeights heights(rows, columns, layers);
    for (int row = 3; row + 3 < rows; ++row)
        for (int column = 3; column + 3 < columns; ++column)
            heights(row, column) = static_cast<std::uint16_t>(
                std::clamp((std::abs(2 * row - rows) + std::abs(2 * column - columns)) / 6, 3, layers));
    return bench::random_merge(heights, {BrickKind::brick, bench::luo_family(), 9});
}

/// The sums of forces and of torques about the origin on each brick, its weight included, from the raw
/// forces.
void expect_equilibrium(const BrickBuild& build, const BrickSupports& supports, const BrickForces& forces,
                        const std::vector<double>& x) {
    struct Sums {
        Vec3d force, torque;
    };
    std::vector<Sums> sums(build.bricks.size());
    for (int column = 0; column < forces.columns(); ++column)
        for (int i = forces.first[column]; i < forces.first[column + 1]; ++i) {
            const PointForce& f = forces.forces[i];
            sums[f.brick].force = sums[f.brick].force + f.force * x[column];
            sums[f.brick].torque = sums[f.brick].torque + cross(f.at, f.force * x[column]);
        }
    Vec3d all;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Brick& b = build.bricks[i];
        const Vec3d centre{b.row + 0.5 * b.rows, b.column + 0.5 * b.columns,
                           (b.bottom + 0.5 * b.height()) * 0.4};
        const Vec3d weight{0, 0, (supports.load == BrickLoad::turned ? 1 : -1) * brick_weight(b)};
        all = all + sums[i].force;
        if (supports.held[i]) continue;
        const Vec3d force = sums[i].force + weight, torque = sums[i].torque + cross(centre, weight);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(force[axis], 0, kTolerance) << "brick " << i;
            EXPECT_NEAR(torque[axis], 0, kTolerance) << "brick " << i;
        }
    }
    // What bricks do to each other cancels: the table alone carries the rest.
    EXPECT_NEAR(all.x, 0, kTolerance);
    EXPECT_NEAR(all.y, 0, kTolerance);
    for (int column = 0; column < forces.columns(); ++column)
        if (!forces.free[column]) {
            EXPECT_GE(x[column], -kTolerance);
        }
}

TEST(BrickStatics, NothingPullsInABrickOnABrick) {
    const BrickBuild build = built(2, 4, {brick(0, 0, 0, 2, 4), brick(1, 0, 0, 2, 4)});
    const BrickStrength result = strength(build, BrickLoad::standing);
    EXPECT_TRUE(result.holds());
    EXPECT_EQ(result.used, 0);
    EXPECT_EQ(result.left_n, kCapacity);
    EXPECT_FALSE(result.weakest);
}

TEST(BrickStatics, AHangingBrickLoadsAllPointsOfItsStudsAlike) {
    const BrickBuild build = built(2, 4, {brick(0, 0, 0, 2, 4), brick(1, 0, 0, 2, 4)});
    const BrickStrength result = strength(build, BrickLoad::lifted);
    EXPECT_TRUE(result.holds());
    const double newtons = 2.2 * kNewtonsPerGram / (8 * 3);
    EXPECT_NEAR(result.left_n, kCapacity - newtons, 1e-6);
    EXPECT_NEAR(result.used, newtons / kCapacity, 1e-6);
    ASSERT_TRUE(result.weakest);
    EXPECT_EQ(result.weakest->lower, 0);
    EXPECT_EQ(result.weakest->upper, 1);
}

TEST(BrickStatics, TwiceTheWeightLoadsTwice) {
    const BrickBuild one = built(2, 4, {brick(0, 0, 0, 2, 4), brick(1, 0, 0, 2, 4)});
    const BrickBuild two = built(2, 4, {brick(0, 0, 0, 2, 4), brick(1, 0, 0, 2, 4), brick(2, 0, 0, 2, 4)});
    EXPECT_NEAR(strength(two, BrickLoad::lifted).used, 2 * strength(one, BrickLoad::lifted).used, 1e-6);

    Random random(7);
    const BrickBuild build = random_build(random);
    const auto joints = brick_joints(build);
    const BrickSupports supports = brick_supports(build, joints, BrickLoad::lifted);
    LinearProgram program =
        equilibrium(build, supports, brick_forces(build, joints, supports, ForceModel::upright));
    const double once = clp_solver()(program, {})->x.front();
    for (double& bound : program.row_lower) bound *= 2;
    program.row_upper = program.row_lower;
    EXPECT_NEAR(clp_solver()(program, {})->x.front(), 2 * once, kTolerance);
}

/// A 1x8 brick on the table, another on its last `studs` studs, the rest of it in the air.
BrickBuild cantilever(int studs) {
    return built(1, 16, {brick(0, 0, 0, 1, 8), brick(1, 0, 8 - studs, 1, 8)});
}

TEST(BrickStatics, ACantileverPullsAsTheLeverSays) {
    const double weight = 3.08;
    for (const int studs : {1, 2, 3}) {
        // About the edge of the lower brick: weight x (4 - studs) = points x grip x studs / 2.
        const double grip = weight * (4 - studs) / (4 * studs * studs / 2.0);
        const BrickStrength result = strength(cantilever(studs), BrickLoad::standing);
        EXPECT_NEAR(result.used, grip * kNewtonsPerGram / kCapacity, 1e-6) << studs;
        EXPECT_TRUE(result.holds());
        // It holds by as much as that, and not by less.
        const double newtons = grip * kNewtonsPerGram;
        EXPECT_TRUE(strength(cantilever(studs), BrickLoad::standing, newtons * 1.001).holds());
        const BrickStrength weak = strength(cantilever(studs), BrickLoad::standing, newtons * 0.999);
        EXPECT_EQ(weak.outcome, StrengthOutcome::overloaded);
        EXPECT_LT(weak.left_n, 0);
        ASSERT_TRUE(weak.weakest);
        EXPECT_EQ(weak.weakest->columns, studs);
    }
    EXPECT_EQ(strength(cantilever(4), BrickLoad::standing).used, 0);
}

TEST(BrickStatics, ACantileverTooLongTipsWhateverTheStudsHold) {
    const auto reaching = [](int out) {
        return built(1, 30, {brick(0, 0, 0, 1, 8), brick(1, 0, 6, 1, 8), brick(2, 0, 12 + out, 1, 2)});
    };
    // The masses in the middle of 4, 10 and 13 + out with 3.08, 3.08 and 0.78 g are above the lower brick.
    EXPECT_TRUE(strength(reaching(0), BrickLoad::standing).holds());
    const BrickBuild longer =
        built(1, 30, {brick(0, 0, 0, 1, 8), brick(1, 0, 6, 1, 8), brick(2, 0, 12, 1, 8)});
    EXPECT_EQ(strength(longer, BrickLoad::standing, 100).outcome, StrengthOutcome::falls);
}

TEST(BrickStatics, ABrickThatNothingTiesFallsOut) {
    // A frame of two layers, and a brick in its middle that reaches no second layer.
    std::vector<Brick> bricks{brick(0, 0, 0, 1, 3), brick(0, 1, 0, 1, 1), brick(0, 1, 1, 1, 1),
                              brick(0, 1, 2, 1, 1), brick(0, 2, 0, 1, 3), brick(1, 0, 0, 3, 1),
                              brick(1, 0, 1, 1, 1), brick(1, 2, 1, 1, 1), brick(1, 0, 2, 3, 1)};
    const BrickBuild build = built(3, 3, bricks);
    EXPECT_TRUE(strength(build, BrickLoad::standing).holds());
    for (const BrickLoad load : {BrickLoad::lifted, BrickLoad::turned}) {
        const BrickStrength result = strength(build, load);
        EXPECT_EQ(result.outcome, StrengthOutcome::loose);
        EXPECT_EQ(result.loose, std::vector<int>{2});
        // That takes no solver.
        EXPECT_EQ(brick_strength(build, load, kCapacity, {})->outcome, StrengthOutcome::loose);
    }
}

TEST(BrickStatics, AHeightFieldStandsWithoutAnyGrip) {
    Random random(11);
    for (int i = 0; i < 10; ++i) {
        const BrickBuild build = random_build(random);
        const auto result = brick_strength(build, BrickLoad::standing, kCapacity, {});
        EXPECT_TRUE(result->holds());
        EXPECT_EQ(result->used, 0);
        const BrickSupports supports = brick_supports(build, brick_joints(build), BrickLoad::standing);
        EXPECT_NEAR(grip_of(build, supports, ForceModel::upright), 0, kTolerance);
    }
}

TEST(BrickStatics, OneGripForAllPointsIsWorthWhatLuosPointsAre) {
    const std::uint64_t seed = 2015;
    Random random(seed);
    for (int i = 0; i < 25; ++i) {
        const BrickBuild build = random_build(random);
        const auto joints = brick_joints(build);
        for (const BrickLoad load : {BrickLoad::lifted, BrickLoad::turned}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", build " + std::to_string(i) + ", " +
                         std::string(brick_load_name(load)));
            const BrickSupports supports = brick_supports(build, joints, load);
            if (!loose_bricks(supports, joints).empty()) continue;
            const double upright = grip_of(build, supports, ForceModel::upright);
            const double full = grip_of(build, supports, ForceModel::full);
            const auto luo = *clp_solver()(test::luo_program(build, supports), {});
            // No grip at all may come out a rounding below 0; what falls is -1.
            ASSERT_EQ(luo.feasible, full >= -kTolerance);
            if (!luo.feasible) continue;
            EXPECT_NEAR(full, luo.x.front(), kTolerance);
            if (upright >= -kTolerance) {
                EXPECT_GE(upright, full - kTolerance);
            }
        }
    }
}

TEST(BrickStatics, ForcesOfEverySolutionBalanceEveryBrick) {
    const std::uint64_t seed = 41;
    Random random(seed);
    for (int i = 0; i < 15; ++i) {
        const BrickBuild build = random_build(random);
        const auto joints = brick_joints(build);
        for (const BrickLoad load : kBrickLoads)
            for (const ForceModel model : {ForceModel::upright, ForceModel::full}) {
                SCOPED_TRACE("seed " + std::to_string(seed) + ", build " + std::to_string(i));
                const BrickSupports supports = brick_supports(build, joints, load);
                const BrickForces forces = brick_forces(build, joints, supports, model);
                const auto solution = *clp_solver()(equilibrium(build, supports, forces), {});
                if (!solution.feasible) continue;
                expect_equilibrium(build, supports, forces, solution.x);
                // The pulls told of joints are no more than the grip, and one of them is the grip.
                const auto pulls = joint_pulls(build, joints, forces, solution.x);
                if (pulls.empty()) continue;
                EXPECT_NEAR(*std::max_element(pulls.begin(), pulls.end()), solution.x.front(), kTolerance);
                if (solution.x.front() < kTolerance) continue;
                const auto parts = joint_parts(build, supports, forces, solution.price);
                EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0), 1, 1e-6);
                for (std::size_t j = 0; j < parts.size(); ++j) {
                    EXPECT_GE(parts[j], -1e-6);
                    if (parts[j] > 1e-3) {
                        EXPECT_NEAR(pulls[j], solution.x.front(), kTolerance);
                    }
                }
            }
    }
}

TEST(BrickStatics, TheOrderOfBricksAndTheMirrorImageChangeNothing) {
    const std::uint64_t seed = 5;
    Random random(seed);
    for (int i = 0; i < 10; ++i) {
        const BrickBuild build = random_build(random);
        BrickBuild shuffled = build, mirrored = build;
        for (std::size_t k = shuffled.bricks.size(); k > 1; --k)
            std::swap(shuffled.bricks[k - 1], shuffled.bricks[random.integer(0, static_cast<int>(k) - 1)]);
        std::stable_sort(shuffled.bricks.begin(), shuffled.bricks.end(),
                         [](const Brick& a, const Brick& b) { return a.bottom < b.bottom; });
        for (Brick& b : mirrored.bricks) b.column = build.columns - b.column - b.columns;
        for (const BrickLoad load : kBrickLoads) {
            const BrickStrength one = strength(build, load);
            for (const BrickBuild& other : {shuffled, mirrored}) {
                const BrickStrength two = strength(other, load);
                EXPECT_EQ(one.outcome, two.outcome) << "seed " << seed << ", build " << i;
                EXPECT_NEAR(one.used, two.used, 1e-5) << "seed " << seed << ", build " << i;
            }
        }
    }
}

TEST(BrickStatics, SpringsBalanceEveryBrickAndNeverClaimMoreThanTheProgram) {
    const std::uint64_t seed = 1660;
    Random random(seed);
    int found = 0;
    for (int i = 0; i < 20; ++i) {
        const BrickBuild build = random_build(random);
        const auto joints = brick_joints(build);
        for (const BrickLoad load : kBrickLoads) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", build " + std::to_string(i) + ", " +
                         std::string(brick_load_name(load)));
            const BrickSupports supports = brick_supports(build, joints, load);
            if (!loose_bricks(supports, joints).empty()) continue;
            const BrickForces forces = brick_forces(build, joints, supports, ForceModel::upright);
            const auto x = *spring_forces(build, joints, supports, forces);
            if (x.empty()) continue;
            ++found;
            expect_equilibrium(build, supports, forces, x);
            EXPECT_GE(x.front(), grip_of(build, supports, ForceModel::upright) - kTolerance);
        }
    }
    EXPECT_GT(found, 30);
}

TEST(BrickStatics, WithoutASolverAHalfThatHoldsEasilyIsKnownToAndOthersAreNotChecked) {
    Random random(3);
    const BrickBuild build = random_build(random);
    const BrickStatics easy = *brick_statics(build, kCapacity, {});
    const BrickStatics known = *brick_statics(build, kCapacity, clp_solver());
    for (std::size_t i = 0; i < easy.size(); ++i) {
        EXPECT_TRUE(easy[i].holds());
        EXPECT_GE(easy[i].used, known[i].used - 1e-6);
        EXPECT_TRUE(known[i].exact);
    }

    const BrickStatics hard = *brick_statics(build, 0.0001, {});
    EXPECT_TRUE(hard[0].holds());
    EXPECT_FALSE(hard[1].checked());
    WorkshopPack pack;
    const DesignSpace space{{9, build.rows, build.columns}, {9.6, 8, 8}};
    tell_statics(build, space, hard, pack);
    EXPECT_EQ(pack.figures.size(), 3u);
    ASSERT_FALSE(pack.findings.empty());
    EXPECT_EQ(pack.findings.front().severity, Severity::note);
    EXPECT_EQ(pack.findings.front().code(), "bricks_unchecked");
}

TEST(BrickStatics, LargeBuildsAreKnownToHoldWithoutTheSolver) {
    const BrickBuild build = large_bowl();
    EXPECT_GT(static_cast<int>(build.bricks.size()), 2 * kFewBricks);
    const LpSolver none = [](const LinearProgram&, const Progress&) -> Result<LpSolution> {
        ADD_FAILURE() << "the solver was asked";
        return LpSolution{};
    };
    const BrickStatics statics = *brick_statics(build, kCapacity, none);
    for (const BrickStrength& each : statics) EXPECT_TRUE(each.holds()) << brick_load_name(each.load);
    EXPECT_FALSE(statics[1].exact);
    EXPECT_TRUE(statics[1].weakest);
}

TEST(BrickStatics, TheCallerCanStopIt) {
    // While springs do it, and while the solver works.
    const BrickBuild large = large_bowl();
    const auto stopped = brick_statics(large, kCapacity, {}, [](double) { return false; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, ErrorKind::cancelled);
    EXPECT_FALSE(brick_strength(large, BrickLoad::lifted, 0.01, clp_solver(),
                                [](double fraction) { return fraction < 0.32; }));
}

TEST(BrickStatics, ProgressGrowsFromNothingToTheEnd) {
    const bench::BrickHeights heights(8, 8, 3);
    const BrickBuild build = bench::random_merge(heights, {BrickKind::brick, bench::luo_family(), 1});
    double last = 0;
    const auto done = brick_statics(build, kCapacity, clp_solver(), [&](double fraction) {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1);
        last = fraction;
        return true;
    });
    EXPECT_TRUE(done);
}

TEST(BrickStatics, WhatComesApartIsToldWithItsPlace) {
    const BrickBuild build = built(2, 4, {brick(0, 0, 0, 2, 4), brick(1, 0, 0, 2, 4)});
    const BrickStatics statics = *brick_statics(build, 0.0001, clp_solver());
    EXPECT_EQ(statics[1].outcome, StrengthOutcome::overloaded);
    WorkshopPack pack;
    tell_statics(build, {{2, 2, 4}, {9.6, 8, 8}}, statics, pack);
    ASSERT_EQ(pack.findings.size(), 1u);
    EXPECT_EQ(pack.findings[0].code(), "bricks_overloaded");
    EXPECT_EQ(pack.findings[0].severity, Severity::warning);
    const Vec3d middle = *pack.findings[0].where;
    EXPECT_NEAR(dot(middle, middle), 0, 1e-20);
}

}  // namespace
}  // namespace snug
