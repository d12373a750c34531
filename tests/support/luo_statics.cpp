#include "tests/support/luo_statics.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "snug/base/vec.h"
#include "snug/fabricate/bricks/brick_forces.h"

namespace snug::test {
namespace {

constexpr double kPlate = 0.4;  // pitches

/// Six rows a brick, torques about the origin; then a row for each pull: grip - pull >= 0.
class Program {
  public:
    Program(const BrickBuild& build, const BrickSupports& supports) : supports_(supports) {
        const double up = supports.load == BrickLoad::turned ? -1 : 1;
        rows_.assign(6 * build.bricks.size(), 0);
        for (std::size_t i = 0; i < build.bricks.size(); ++i) {
            const Brick& b = build.bricks[i];
            const double weight = up * brick_weight(b);
            // Contact forces in sum carry the weight at the middle.
            rows_[6 * i + 2] = weight;
            rows_[6 * i + 3] = (b.column + b.columns / 2.0) * weight;
            rows_[6 * i + 4] = -(b.row + b.rows / 2.0) * weight;
        }
        column({});
        program_.cost[0] = 1;
    }

    struct Force {
        int brick;
        Vec3d at, direction;
    };

    void pair(int a, int b, Vec3d at, Vec3d direction, bool free = false) {
        column({{a, at, direction}, {b, at, direction * -1.0}}, free);
    }
    void column(const std::vector<Force>& forces, bool free = false) {
        std::map<int, double> entries;
        for (const Force& f : forces) {
            if (supports_.held[f.brick]) continue;
            const Vec3d torque = cross(f.at, f.direction);
            for (int axis = 0; axis < 3; ++axis) {
                entries[6 * f.brick + axis] += f.direction[axis];
                entries[6 * f.brick + 3 + axis] += torque[axis];
            }
        }
        columns_.push_back(std::move(entries));
        program_.cost.push_back(0);
        program_.lower.push_back(free ? -kUnbounded : 0);
        program_.upper.push_back(kUnbounded);
    }
    void pull(int lower, int upper, Vec3d at) {
        pair(lower, upper, at, {0, 0, 1});
        const int row = static_cast<int>(rows_.size()) + pulls_++;
        columns_.back()[row] = -1;
        columns_.front()[row] = 1;
    }

    LinearProgram finish() {
        for (const auto& entries : columns_) {
            for (const auto& [row, value] : entries) {
                if (value == 0) continue;
                program_.row.push_back(row);
                program_.value.push_back(value);
            }
            program_.first.push_back(static_cast<int>(program_.row.size()));
        }
        program_.row_lower = program_.row_upper = rows_;
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (supports_.held[i / 6]) {
                program_.row_lower[i] = -kUnbounded;
                program_.row_upper[i] = kUnbounded;
            }
        program_.row_lower.resize(rows_.size() + static_cast<std::size_t>(pulls_), 0);
        program_.row_upper.resize(rows_.size() + static_cast<std::size_t>(pulls_), kUnbounded);
        return program_;
    }

  private:
    const BrickSupports& supports_;
    LinearProgram program_;
    std::vector<double> rows_;
    std::vector<std::map<int, double>> columns_;
    int pulls_ = 0;
};

void add_joint(Program& program, const Brick& upper, const BrickJoint& j) {
    const double z = upper.bottom * kPlate;
    const std::vector<Vec3d> four{{0.25, 0, 0}, {-0.25, 0, 0}, {0, 0.25, 0}, {0, -0.25, 0}};
    const std::vector<Vec3d> three{{0.125, 0.125, 0}, {0.125, -0.125, 0}, {-0.25, 0, 0}};
    const bool narrow = upper.rows == 1 || upper.columns == 1;
    for (int r = j.row; r < j.row + j.rows; ++r)
        for (int c = j.column; c < j.column + j.columns; ++c)
            for (const Vec3d& point : narrow ? four : three)
                program.pull(j.lower, j.upper, Vec3d{r + 0.5, c + 0.5, z} + point);
    for (const int r : {j.row, j.row + j.rows})
        for (const int c : {j.column, j.column + j.columns})
            program.pair(j.upper, j.lower, {double(r), double(c), z}, {0, 0, 1});
    const double r = j.row + j.rows / 2.0, c = j.column + j.columns / 2.0;
    program.pair(j.upper, j.lower, {r, c, z}, {1, 0, 0}, true);
    program.pair(j.upper, j.lower, {r, c, z}, {0, 1, 0}, true);
    if (j.rows * j.columns > 1) {
        // A couple about the upright axis.
        program.column({{j.upper, {r + 1, c, z}, {0, 1, 0}},
                        {j.upper, {r - 1, c, z}, {0, -1, 0}},
                        {j.lower, {r + 1, c, z}, {0, -1, 0}},
                        {j.lower, {r - 1, c, z}, {0, 1, 0}}},
                       true);
    }
}

void add_neighbours(Program& program, const BrickBuild& build) {
    for (int i = 0; i < static_cast<int>(build.bricks.size()); ++i)
        for (int k = 0; k < static_cast<int>(build.bricks.size()); ++k) {
            const Brick &a = build.bricks[i], &b = build.bricks[k];
            const double low = std::max(a.bottom, b.bottom) * kPlate,
                         high = std::min(a.top(), b.top()) * kPlate;
            if (low >= high) continue;
            const double first_row = std::max(a.row, b.row);
            const double end_row = std::min(a.row + a.rows, b.row + b.rows);
            const double first_column = std::max(a.column, b.column);
            const double end_column = std::min(a.column + a.columns, b.column + b.columns);
            for (const double z : {low, high}) {
                if (a.row + a.rows == b.row && first_column < end_column)
                    for (const double c : {first_column, end_column})
                        program.pair(k, i, {double(b.row), c, z}, {1, 0, 0});
                if (a.column + a.columns == b.column && first_row < end_row)
                    for (const double r : {first_row, end_row})
                        program.pair(k, i, {r, double(b.column), z}, {0, 1, 0});
            }
        }
}

}  // namespace

LinearProgram luo_program(const BrickBuild& build, const BrickSupports& supports) {
    Program program(build, supports);
    for (const BrickJoint& joint : brick_joints(build)) add_joint(program, build.bricks[joint.upper], joint);
    add_neighbours(program, build);
    const bool turned = supports.load == BrickLoad::turned;
    for (int i = 0; i < static_cast<int>(build.bricks.size()); ++i) {
        if (!supports.resting[i]) continue;
        const Brick& b = build.bricks[i];
        const double inset = turned && b.has_studs() ? 0.2 : 0;
        for (const double r : {b.row + inset, b.row + b.rows - inset})
            for (const double c : {b.column + inset, b.column + b.columns - inset})
                program.column(
                    {{i, {r, c, (turned ? b.top() : b.bottom) * kPlate}, {0, 0, turned ? -1.0 : 1.0}}});
    }
    return program.finish();
}

}  // namespace snug::test
