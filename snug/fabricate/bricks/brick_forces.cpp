#include "snug/fabricate/bricks/brick_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace snug {
namespace {

constexpr double kUp = kPlateHeight / kBrickPitch;  // pitches of a plate
/// Between the outline and the outermost studs (4.8 mm wide) in pitches: what stands on its studs stands
/// on these.
constexpr double kStudInset = 0.2;
constexpr double kGramsPerStud = 0.3;  // of a brick that no list has

/// A rectangle of the grid of studs, or of a side: from `low` to `high`, equal along one axis.
struct Rectangle {
    Vec3d low, high;

    [[nodiscard]] Vec3d centre() const { return (low + high) * 0.5; }
};

Rectangle rectangle_of(const BrickJoint& joint, int height) {
    const double up = height * kUp;
    return {{double(joint.row), double(joint.column), up},
            {double(joint.row + joint.rows), double(joint.column + joint.columns), up}};
}

Vec3d centre_of(const Brick& brick) {
    return {brick.row + 0.5 * brick.rows, brick.column + 0.5 * brick.columns,
            (brick.bottom + 0.5 * brick.height()) * kUp};
}

/// Collects columns.
class Columns {
  public:
    explicit Columns(BrickForces& forces) : forces_(forces) {}

    void add(int brick, Vec3d at, Vec3d force) { forces_.forces.push_back({brick, at, force}); }
    /// As much on the one as, the other way, on the other.
    void add_pair(int brick, int other, Vec3d at, Vec3d force) {
        add(brick, at, force);
        add(other, at, force * -1.0);
    }
    int finish(bool free = false) {
        forces_.first.push_back(static_cast<int>(forces_.forces.size()));
        forces_.free.push_back(free);
        return forces_.columns() - 1;
    }

  private:
    BrickForces& forces_;
};

/// Round the rectangle, so that corners 0 and 2 and corners 1 and 3 face each other.
std::array<Vec3d, 4> corners_of(const Rectangle& area) {
    std::array<Vec3d, 4> corners{area.low, area.low, area.high, area.high};
    // The axis along which the second corner is one step further: the first along which there is a step.
    if (area.low.x != area.high.x) {
        corners[1].x = area.high.x;
        corners[3].x = area.low.x;
    } else {
        corners[1].y = area.high.y;
        corners[3].y = area.low.y;
    }
    return corners;
}

void add_grip(const BrickBuild& build, const std::vector<BrickJoint>& joints, Columns& columns) {
    for (const BrickJoint& joint : joints) {
        const Brick& upper = build.bricks[joint.upper];
        const double points = joint.rows * joint.columns * contact_points(upper);
        columns.add_pair(joint.lower, joint.upper, rectangle_of(joint, upper.bottom).centre(),
                         {0, 0, points});
    }
    columns.finish();
}

void add_press(const BrickBuild& build, const std::vector<BrickJoint>& joints, Columns& columns,
               BrickForces& forces) {
    for (const BrickJoint& joint : joints) {
        forces.press.push_back(forces.columns());
        for (const Vec3d corner : corners_of(rectangle_of(joint, build.bricks[joint.upper].bottom))) {
            columns.add_pair(joint.upper, joint.lower, corner, {0, 0, 1});
            columns.finish();
        }
    }
}

/// The table at the bottom of what stands on it, and above what was turned over: at its studs if it has
/// some.
void add_table(const BrickBuild& build, const BrickSupports& supports, Columns& columns) {
    const bool turned = supports.load == BrickLoad::turned;
    for (std::size_t i = 0; i < build.bricks.size(); ++i) {
        if (!supports.resting[i]) continue;
        const Brick& brick = build.bricks[i];
        const double inset = turned && brick.has_studs() ? kStudInset : 0;
        const double up = (turned ? brick.top() : brick.bottom) * kUp;
        const Rectangle area{{brick.row + inset, brick.column + inset, up},
                             {brick.row + brick.rows - inset, brick.column + brick.columns - inset, up}};
        for (const Vec3d corner : corners_of(area)) {
            columns.add(static_cast<int>(i), corner, {0, 0, turned ? -1.0 : 1.0});
            columns.finish();
        }
    }
}

/// What snapped bricks do to each other sideways.
void add_shear(const BrickBuild& build, const std::vector<BrickJoint>& joints, Columns& columns) {
    for (const BrickJoint& joint : joints) {
        const Rectangle area = rectangle_of(joint, build.bricks[joint.upper].bottom);
        const Vec3d centre = area.centre();
        for (const Vec3d direction : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}) {
            columns.add_pair(joint.upper, joint.lower, centre, direction);
            columns.finish(true);
        }
        if (joint.rows * joint.columns == 1) continue;
        // Two studs at the ends of the longer side push opposite ways.
        const bool along_rows = joint.rows >= joint.columns;
        const double arm = 0.5 * (std::max(joint.rows, joint.columns) - 1);
        const Vec3d end = along_rows ? Vec3d{arm, 0, 0} : Vec3d{0, arm, 0};
        const Vec3d push = along_rows ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
        columns.add_pair(joint.upper, joint.lower, centre + end, push);
        columns.add_pair(joint.upper, joint.lower, centre - end, push * -1.0);
        columns.finish(true);
    }
}

/// The sides that bricks end at or begin at, by their plane.
struct Side {
    int brick = 0;
    int begin = 0, end = 0;  ///< along the plane, in studs
    int bottom = 0, top = 0;
};

void add_side_presses(const std::vector<Side>& ending, const std::vector<Side>& beginning, int plane,
                      bool across_rows, Columns& columns) {
    const double at = plane;
    for (const Side& a : ending)
        for (const Side& b : beginning) {
            const double begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
            const double bottom = std::max(a.bottom, b.bottom) * kUp, top = std::min(a.top, b.top) * kUp;
            if (begin >= end || bottom >= top) continue;
            const Rectangle area = across_rows ? Rectangle{{at, begin, bottom}, {at, end, top}}
                                               : Rectangle{{begin, at, bottom}, {end, at, top}};
            for (const Vec3d corner : corners_of(area)) {
                columns.add_pair(b.brick, a.brick, corner, across_rows ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
                columns.finish();
            }
        }
}

/// What neighbours do to each other.
void add_neighbours(const BrickBuild& build, Columns& columns) {
    for (const bool across_rows : {true, false}) {
        std::map<int, std::vector<Side>> ending, beginning;
        for (std::size_t i = 0; i < build.bricks.size(); ++i) {
            const Brick& brick = build.bricks[i];
            const int first = across_rows ? brick.row : brick.column;
            const int size = across_rows ? brick.rows : brick.columns;
            const int begin = across_rows ? brick.column : brick.row;
            const Side side{static_cast<int>(i), begin, begin + (across_rows ? brick.columns : brick.rows),
                            brick.bottom, brick.top()};
            beginning[first].push_back(side);
            ending[first + size].push_back(side);
        }
        for (const auto& [plane, sides] : ending)
            if (const auto other = beginning.find(plane); other != beginning.end())
                add_side_presses(sides, other->second, plane, across_rows, columns);
    }
}

constexpr int kMostRows = 6;
int rows_of(ForceModel model) {
    return model == ForceModel::full ? kMostRows : 3;
}

/// Of each brick; -1: held ones have none.
std::vector<int> first_rows(const BrickSupports& supports, ForceModel model) {
    std::vector<int> rows;
    int next = 0;
    for (const char held : supports.held) {
        rows.push_back(held ? -1 : next);
        if (!held) next += rows_of(model);
    }
    return rows;
}

/// What a force on a brick adds to that brick's rows.
std::array<double, kMostRows> effect_of(const PointForce& force, Vec3d centre) {
    const Vec3d torque = cross(force.at - centre, force.force);
    return {force.force.z, torque.x, torque.y, force.force.x, force.force.y, torque.z};
}

}  // namespace

double brick_weight(const Brick& brick) {
    const BrickPart* part =
        brick_part(brick.kind, std::min(brick.rows, brick.columns), std::max(brick.rows, brick.columns));
    return part ? part->mass_g : kGramsPerStud * brick.studs() * brick.height() / kPlatesInBrick;
}

int contact_points(const Brick& upper) {
    return std::min(upper.rows, upper.columns) == 1 ? 4 : 3;
}

BrickForces brick_forces(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                         const BrickSupports& supports, ForceModel model) {
    BrickForces forces;
    forces.model = model;
    Columns columns(forces);
    add_grip(build, joints, columns);
    add_press(build, joints, columns, forces);
    add_table(build, supports, columns);
    if (model == ForceModel::full) {
        add_shear(build, joints, columns);
        add_neighbours(build, columns);
    }
    return forces;
}

LinearProgram equilibrium(const BrickBuild& build, const BrickSupports& supports, const BrickForces& forces) {
    const int rows_of_brick = rows_of(forces.model);
    const std::vector<int> first_row = first_rows(supports, forces.model);
    LinearProgram program;
    for (std::size_t i = 0; i < build.bricks.size(); ++i) {
        if (supports.held[i]) continue;
        const double weight = brick_weight(build.bricks[i]);
        program.row_lower.push_back(supports.load == BrickLoad::turned ? -weight : weight);
        program.row_lower.resize(program.row_lower.size() + static_cast<std::size_t>(rows_of_brick - 1));
    }
    program.row_upper = program.row_lower;

    std::vector<double> sums(program.row_lower.size());
    std::vector<int> touched;
    for (int column = 0; column < forces.columns(); ++column) {
        for (int i = forces.first[column]; i < forces.first[column + 1]; ++i) {
            const PointForce& force = forces.forces[i];
            const int row = first_row[force.brick];
            if (row < 0) continue;
            const auto effect = effect_of(force, centre_of(build.bricks[force.brick]));
            for (int k = 0; k < rows_of_brick; ++k) {
                if (effect[k] == 0) continue;
                touched.push_back(row + k);
                sums[row + k] += effect[k];
            }
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (const int row : touched) {
            // Halves and fifths that cancel leave crumbs.
            if (std::abs(sums[row]) > 1e-9) {
                program.row.push_back(row);
                program.value.push_back(sums[row]);
            }
            sums[row] = 0;
        }
        touched.clear();
        program.first.push_back(static_cast<int>(program.row.size()));
        program.cost.push_back(column == 0 ? 1 : 0);
        program.lower.push_back(forces.free[column] ? -kUnbounded : 0);
        program.upper.push_back(kUnbounded);
    }
    return program;
}

std::vector<double> joint_pulls(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                                const BrickForces& forces, const std::vector<double>& x) {
    std::vector<double> pulls;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const BrickJoint& joint = joints[i];
        const double* press = x.data() + forces.press[i];
        // Of four corners, opposite ones can hand each other's force to the other two. What all four then
        // press at least is a press in the middle, which takes back that much of all points' pulls.
        const double in_the_middle = 2 * (std::min(press[0], press[2]) + std::min(press[1], press[3]));
        const int points = joint.rows * joint.columns * contact_points(build.bricks[joint.upper]);
        pulls.push_back(std::max(0.0, x[0] - in_the_middle / points));
    }
    return pulls;
}

std::vector<double> joint_parts(const BrickBuild& build, const BrickSupports& supports,
                                const BrickForces& forces, const std::vector<double>& price) {
    const std::vector<int> first_row = first_rows(supports, forces.model);
    std::vector<double> parts(forces.press.size());
    for (int i = 0; i < forces.first[1]; ++i) {
        const PointForce& force = forces.forces[i];
        const int row = first_row[force.brick];
        if (row < 0) continue;
        const auto effect = effect_of(force, centre_of(build.bricks[force.brick]));
        for (int k = 0; k < rows_of(forces.model); ++k) parts[i / 2] += effect[k] * price[row + k];
    }
    return parts;
}

}  // namespace snug
