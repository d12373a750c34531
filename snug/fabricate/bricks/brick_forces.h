#pragma once

#include <vector>

#include "snug/base/vec.h"
#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_supports.h"
#include "snug/fabricate/bricks/linear_program.h"

// Bricks as rigid bodies that press and hold each other: the linear program of Luo et al., "Legolization:
// Optimizing LEGO Designs" (SIGGRAPH Asia 2015, section 4), in a form that takes seconds for thousands of
// bricks.
//
// The paper gives each stud 3 or 4 contact points with a pull of their own and each contact rectangle a
// pressing force at each of its corners, and asks for the forces in equilibrium whose largest pull is
// least. Here every contact point pulls with one and the same force, the `grip`: one column for the whole
// build instead of one for each point. That loses nothing. Take any solution of the paper's and raise every
// pull to its largest, u. Each raise is taken back by as large a press at the same point; the points lie
// within the contact rectangle, so its four corners can press instead, and nothing limits a press. So each
// solution of the paper's with the largest pull u is one of ours with the grip u, and the other way round
// (the net forces of a point that pulls and is pressed are those of the paper).
//
// Lengths are in pitches (8 mm), forces in grams (of weight); places are (row, column, height), which are
// right-handed.

namespace snug {

constexpr double kNewtonsPerGram = 9.81e-3;

enum class ForceModel {
    /// Upright forces, and on each brick the sums of forces and of the two tilting torques. Its columns are
    /// the first of the full model's, its solutions are solutions there, where nothing need push sideways,
    /// and so its grip is never less.
    upright,
    /// Besides, bricks that snap together push each other sideways in any direction and, by more studs than
    /// one, turn each other about the upright axis (studs do not shear off); neighbours press each other at
    /// the corners of the sides that they share.
    full,
};

/// One part of what a column of the program does: a force on a brick.
struct PointForce {
    int brick = 0;
    Vec3d at, force;
};

/// All that bricks may do to each other. Column c of the program stands for the forces first[c] to
/// first[c + 1] - 1, all multiplied by its value; column 0 is the grip.
struct BrickForces {
    ForceModel model = ForceModel::upright;
    std::vector<PointForce> forces;  ///< the grip's: of each joint that on the lower, then on the upper brick
    std::vector<int> first{0};
    std::vector<char> free;  ///< of each column: may be less than 0
    std::vector<int> press;  ///< of each joint: the first of the columns of its four corners

    [[nodiscard]] int columns() const { return static_cast<int>(free.size()); }
};

[[nodiscard]] BrickForces brick_forces(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                       const BrickSupports& supports, ForceModel model);

/// minimise the grip, all bricks but the held ones in equilibrium with their weights. In the order of the
/// bricks, held ones left out, a brick has the rows: sum of the upright forces, torques about the axes of
/// rows and of columns; in the full model then the sums along rows and along columns and the torque about
/// the upright axis.
[[nodiscard]] LinearProgram equilibrium(const BrickBuild& build, const BrickSupports& supports,
                                        const BrickForces& forces);

/// Grams that the brick weighs; by its studs where no such part is sold.
[[nodiscard]] double brick_weight(const Brick& brick);
/// Contact points that hold one stud: 4 in bricks one stud wide, 3 in all others (sections 4.1 and 5).
[[nodiscard]] int contact_points(const Brick& upper);

/// What a point of each joint has to hold, in grams, in a solution of the program: the grip less what the
/// presses at the joint's corners take back.
[[nodiscard]] std::vector<double> joint_pulls(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                              const BrickForces& forces, const std::vector<double>& x);

/// How each joint takes part in the way in which the build would give first, all parts together 1 where the
/// grip is more than 0: the prices of a brick's rows in the program's solution are the speeds at which the
/// brick would move then (the dual program), and a joint's part is the speed at which its studs would come
/// off, times its contact points. A joint with a part pulls with the whole grip in every solution.
[[nodiscard]] std::vector<double> joint_parts(const BrickBuild& build, const BrickSupports& supports,
                                              const BrickForces& forces, const std::vector<double>& price);

}  // namespace snug
