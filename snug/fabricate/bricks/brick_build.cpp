#include "snug/fabricate/bricks/brick_build.h"

#include <algorithm>

#include "snug/base/grid.h"

namespace snug {

std::vector<BrickJoint> brick_joints(const BrickBuild& build) {
    Grid<int> highest(build.rows, build.columns, -1);  // of the bricks so far, at each stud
    std::vector<BrickJoint> joints;
    std::vector<int> below;
    for (int i = 0; i < static_cast<int>(build.bricks.size()); ++i) {
        const Brick& brick = build.bricks[static_cast<std::size_t>(i)];
        below.clear();
        for (int row = brick.row; row < brick.row + brick.rows; ++row)
            for (int column = brick.column; column < brick.column + brick.columns; ++column) {
                int& at = highest(row, column);
                if (at >= 0) {
                    const Brick& under = build.bricks[static_cast<std::size_t>(at)];
                    if (under.top() == brick.bottom && under.has_studs()) below.push_back(at);
                }
                at = i;
            }
        std::sort(below.begin(), below.end());
        below.erase(std::unique(below.begin(), below.end()), below.end());
        for (const int lower : below) {
            const Brick& under = build.bricks[static_cast<std::size_t>(lower)];
            const int row = std::max(under.row, brick.row), column = std::max(under.column, brick.column);
            joints.push_back({lower, i, row, column,
                              std::min(under.row + under.rows, brick.row + brick.rows) - row,
                              std::min(under.column + under.columns, brick.column + brick.columns) - column});
        }
    }
    return joints;
}

}  // namespace snug
