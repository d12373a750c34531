#include "snug/fabricate/bricks/brick_springs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace snug {
namespace {

/// How a brick moved: up, and turned about the axes of rows and of columns. Also: what pushes and turns it.
using Motion = Vec3d;

/// Rows of `equilibrium` for one brick are met to within this, in grams and gram pitches.
constexpr double kExact = 1e-7;

/// The spring between two bodies: stiff against parting and against tilting, about its middle.
struct Spring {
    int upper = -1, lower = -1;  ///< numbers of free bricks; -1: what does not move
    double row = 0, column = 0;  ///< the middle
    Motion stiffness;
    Motion force;  ///< on the upper body
};

enum class Rest { found, none, cancelled };

/// Round the contact rectangle as brick_forces.h has its corners.
constexpr std::array<std::array<int, 2>, 4> kCornerSigns{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

class SpringModel {
  public:
    SpringModel(const BrickBuild& build, const std::vector<BrickJoint>& joints, const BrickSupports& supports,
                const BrickForces& forces)
        : joints_(joints), forces_(forces) {
        std::vector<int> number(build.bricks.size(), -1);
        for (std::size_t i = 0; i < build.bricks.size(); ++i) {
            if (supports.held[i]) continue;
            const Brick& brick = build.bricks[i];
            number[i] = static_cast<int>(rows_.size());
            rows_.push_back(brick.row + 0.5 * brick.rows);
            columns_.push_back(brick.column + 0.5 * brick.columns);
            const double weight = brick_weight(brick);
            load_.push_back({supports.load == BrickLoad::turned ? weight : -weight, 0, 0});
        }
        for (const BrickJoint& joint : joints) {
            Spring spring{number[joint.upper],
                          number[joint.lower],
                          joint.row + 0.5 * joint.rows,
                          joint.column + 0.5 * joint.columns,
                          {},
                          {}};
            springs_.push_back(spring);
            points_.push_back(joint.rows * joint.columns * contact_points(build.bricks[joint.upper]));
        }
        softness_.assign(joints.size(), 1);
        // The table's columns of the program, one a corner.
        const int first_of_table = forces.press.empty() ? 1 : forces.press.back() + 4;
        for (int column = first_of_table; column < forces.columns(); ++column) {
            const PointForce& push = forces.forces[forces.first[column]];
            Spring spring{number[push.brick], -1, push.at.x, push.at.y, {}, {}};
            springs_.push_back(spring);
            up_.push_back(push.force.z);
        }
        touching_.assign(up_.size(), 1);
        motion_.resize(rows_.size());
    }

    /// Lets the bricks come to rest.
    Rest settle(const Progress& progress) {
        constexpr int kMostRounds = 40;
        constexpr double kRough = 1e-3;  // will do to see which corners touch the table
        double tolerance = up_.empty() ? kExact : kRough;
        steps_ = 0;
        for (int round = 0; round < kMostRounds; ++round) {
            const Rest rest = solve(tolerance, progress);
            if (rest != Rest::found) return rest;
            if (lift_off()) continue;
            if (tolerance == kExact) return Rest::found;
            tolerance = kExact;
        }
        return Rest::none;
    }

    /// The forces as values of the program's columns.
    [[nodiscard]] std::vector<double> solution() const {
        std::vector<double> x(forces_.columns());
        std::vector<std::array<double, 4>> corners(joints_.size());
        double grip = 0;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            corners[i] = corner_forces(i);
            grip = std::max(grip, pull_of(i, corners[i]));
        }
        x[0] = grip;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            // With the grip taken back at all corners alike; what opposite corners lack the others hand over.
            auto press = corners[i];
            for (double& force : press) force += grip * points_[i] / 4;
            const double lack = std::min(press[0], press[2]), spare = std::min(press[1], press[3]);
            const double handed = (spare - lack) / 2;
            for (int corner = 0; corner < 4; ++corner)
                x[forces_.press[i] + corner] =
                    std::max(0.0, press[corner] + (corner % 2 == 0 ? handed : -handed));
        }
        for (std::size_t i = 0; i < up_.size(); ++i)
            x[x.size() - up_.size() + i] = springs_[joints_.size() + i].force.x * up_[i];
        return x;
    }

    /// Softens the springs that pull most.
    void soften() {
        std::vector<double> pulls;
        for (std::size_t i = 0; i < joints_.size(); ++i) pulls.push_back(pull_of(i, corner_forces(i)));
        const double most = pulls.empty() ? 0 : *std::max_element(pulls.begin(), pulls.end());
        if (most <= 0) return;
        // Springs with a softness of the pull to the power p - 2 settle where the p-norm of the pulls is
        // least (iteratively reweighted least squares), here with p = 4; a quarter of the step at a time,
        // which does not swing. What hardly pulls is not told from what is pressed. Roots of squares are the
        // same on every system, powers are not.
        constexpr double kLeastShare = 0.1;
        for (std::size_t i = 0; i < pulls.size(); ++i) {
            const double share = std::max(pulls[i] / most, kLeastShare);
            softness_[i] = softness_[i] / std::sqrt(std::sqrt(softness_[i])) * std::sqrt(share);
        }
    }

  private:
    /// What the motions of both bodies come to in the middle of the spring.
    [[nodiscard]] Motion opening(const Spring& spring, const std::vector<Motion>& motion) const {
        Motion open;
        const auto add = [&](int body, double sign) {
            if (body < 0) return;
            const Motion& m = motion[body];
            const double up = m.x + m.y * (spring.column - columns_[body]) - m.z * (spring.row - rows_[body]);
            open = open + Motion{up, m.y, m.z} * sign;
        };
        add(spring.upper, 1);
        add(spring.lower, -1);
        return open;
    }

    /// Adds a force in the middle of the spring to the sums of both bodies.
    void push(const Spring& spring, Motion force, std::vector<Motion>& sums) const {
        const auto add = [&](int body, double sign) {
            if (body < 0) return;
            sums[body] = sums[body] + Motion{force.x, force.y + force.x * (spring.column - columns_[body]),
                                             force.z - force.x * (spring.row - rows_[body])} *
                                          sign;
        };
        add(spring.upper, 1);
        add(spring.lower, -1);
    }

    void stiffen() {
        for (std::size_t i = 0; i < springs_.size(); ++i) {
            Spring& spring = springs_[i];
            if (i >= joints_.size()) {
                spring.stiffness = {touching_[i - joints_.size()] ? 4.0 : 0.0, 0, 0};
                continue;
            }
            // As if spread evenly over the rectangle.
            const double rows = joints_[i].rows, columns = joints_[i].columns;
            spring.stiffness =
                Motion{1, columns * columns / 12, rows * rows / 12} * (rows * columns / softness_[i]);
        }
    }

    /// sums = K motion, the forces that would hold the bricks in that motion.
    void apply(const std::vector<Motion>& motion, std::vector<Motion>& sums) const {
        std::fill(sums.begin(), sums.end(), Motion{});
        for (const Spring& spring : springs_) {
            const Motion open = opening(spring, motion);
            push(spring,
                 {open.x * spring.stiffness.x, open.y * spring.stiffness.y, open.z * spring.stiffness.z},
                 sums);
        }
    }

    using Block = std::array<double, 9>;

    /// The inverse of each brick's own 3 x 3 block of K, the preconditioner.
    [[nodiscard]] std::vector<Block> own_blocks() const {
        std::vector<Block> blocks(rows_.size(), Block{});
        for (const Spring& spring : springs_)
            for (const int body : {spring.upper, spring.lower}) {
                if (body < 0) continue;
                // The opening by each of the three motions.
                const double dc = spring.column - columns_[body], dr = spring.row - rows_[body];
                const Motion by[3] = {{1, 0, 0}, {dc, 1, 0}, {-dr, 0, 1}};
                for (int i = 0; i < 3; ++i)
                    for (int k = 0; k < 3; ++k)
                        for (int axis = 0; axis < 3; ++axis)
                            blocks[body][3 * i + k] += by[i][axis] * spring.stiffness[axis] * by[k][axis];
            }
        for (Block& block : blocks) block = inverse(block);
        return blocks;
    }

    static Block inverse(const Block& m) {
        const Vec3d a{m[0], m[1], m[2]}, b{m[3], m[4], m[5]}, c{m[6], m[7], m[8]};
        const Vec3d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
        const double det = dot(a, bc);
        if (!(std::abs(det) > 1e-12)) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
        return {bc.x / det, ca.x / det, ab.x / det, bc.y / det, ca.y / det,
                ab.y / det, bc.z / det, ca.z / det, ab.z / det};
    }

    static double product(const std::vector<Motion>& a, const std::vector<Motion>& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
        return sum;
    }

    static double largest(const std::vector<Motion>& a) {
        double most = 0;
        for (const Motion& m : a)
            for (int axis = 0; axis < 3; ++axis) most = std::max(most, std::abs(m[axis]));
        return most;
    }

    /// Conjugate gradients from where the bricks are.
    Rest solve(double tolerance, const Progress& progress) {
        stiffen();
        const std::vector<Block> blocks = own_blocks();
        const std::size_t count = rows_.size();
        std::vector<Motion> residual(count), direction(count), sums(count), scaled(count);
        const auto precondition = [&] {
            for (std::size_t i = 0; i < count; ++i) {
                const Block& m = blocks[i];
                const Motion& r = residual[i];
                scaled[i] = {m[0] * r.x + m[1] * r.y + m[2] * r.z, m[3] * r.x + m[4] * r.y + m[5] * r.z,
                             m[6] * r.x + m[7] * r.y + m[8] * r.z};
            }
        };
        const auto measure = [&] {
            apply(motion_, sums);
            for (std::size_t i = 0; i < count; ++i) residual[i] = load_[i] - sums[i];
        };
        measure();
        const int most_steps = 2000 + static_cast<int>(count);
        double before = 0;
        for (int step = 0; step < most_steps && largest(residual) > tolerance; ++step) {
            // Nobody knows how many steps it takes: about a quarter of the bricks.
            if (++steps_ % 64 == 0 && !go_on(progress, steps_ / (steps_ + 0.25 * static_cast<double>(count))))
                return Rest::cancelled;
            // Rounding makes the running residual drift from the true one.
            if (step % 200 == 199) measure();
            precondition();
            const double now = product(residual, scaled);
            const double keep = step % 200 == 0 || step % 200 == 199 ? 0 : now / before;
            before = now;
            for (std::size_t i = 0; i < count; ++i) direction[i] = scaled[i] + direction[i] * keep;
            apply(direction, sums);
            const double curvature = product(direction, sums);
            if (!(curvature > 0)) return Rest::none;
            const double length = now / curvature;
            for (std::size_t i = 0; i < count; ++i) {
                motion_[i] = motion_[i] + direction[i] * length;
                residual[i] = residual[i] - sums[i] * length;
            }
        }
        measure();
        if (!(largest(residual) <= 10 * tolerance)) return Rest::none;
        for (Spring& spring : springs_) {
            const Motion open = opening(spring, motion_);
            spring.force = Motion{open.x * spring.stiffness.x, open.y * spring.stiffness.y,
                                  open.z * spring.stiffness.z} *
                           -1.0;
        }
        return Rest::found;
    }

    /// The table lets go of corners that it would have to pull, and catches those that sink into it; whether
    /// any changed.
    bool lift_off() {
        bool changed = false;
        for (std::size_t i = 0; i < touching_.size(); ++i) {
            const Spring& spring = springs_[joints_.size() + i];
            const double sunk = -opening(spring, motion_).x * up_[i];
            const char touches = sunk > 0;
            // What hardly touches may stay, or rounding would have the last word.
            if (touches == touching_[i] || std::abs(sunk) < 1e-12) continue;
            touching_[i] = touches;
            changed = true;
        }
        return changed;
    }

    /// The joint's force on its upper brick as four at the corners.
    [[nodiscard]] std::array<double, 4> corner_forces(std::size_t i) const {
        const Motion& f = springs_[i].force;
        std::array<double, 4> corners{};
        for (int corner = 0; corner < 4; ++corner)
            corners[corner] = f.x / 4 + f.y * kCornerSigns[corner][1] / (2.0 * joints_[i].columns) -
                              f.z * kCornerSigns[corner][0] / (2.0 * joints_[i].rows);
        return corners;
    }

    /// The least pull of all the joint's points with which presses at the corners make up these forces.
    [[nodiscard]] double pull_of(std::size_t i, const std::array<double, 4>& corners) const {
        return std::max(
            0.0, -2 * (std::min(corners[0], corners[2]) + std::min(corners[1], corners[3])) / points_[i]);
    }

    const std::vector<BrickJoint>& joints_;
    const BrickForces& forces_;
    std::vector<double> rows_, columns_;  ///< middles of the free bricks
    std::vector<Motion> load_, motion_;   ///< of the free bricks
    std::vector<Spring> springs_;         ///< of the joints, then of the table's corners
    std::vector<double> softness_;        ///< of the joints
    std::vector<int> points_;             ///< of the joints
    std::vector<double> up_;              ///< of the table's corners: the way it pushes
    std::vector<char> touching_;          ///< of the table's corners
    int steps_ = 0;
};

}  // namespace

Result<std::vector<double>> spring_forces(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                          const BrickSupports& supports, const BrickForces& forces,
                                          double enough, const Progress& progress) {
    constexpr int kRounds = 6;
    SpringModel model(build, joints, supports, forces);
    std::vector<double> best;
    for (int round = 0; round < kRounds; ++round) {
        const Progress part =
            part_of(progress, static_cast<double>(round) / kRounds, (round + 1.0) / kRounds);
        const Rest rest = model.settle(part);
        if (rest == Rest::cancelled) return fail(ErrorKind::cancelled, say("cancelled.nothing_written"));
        if (rest == Rest::none) break;
        std::vector<double> x = model.solution();
        if (best.empty() || x[0] < best[0]) best = std::move(x);
        if (best[0] <= enough) break;
        model.soften();
    }
    return best;
}

}  // namespace snug
