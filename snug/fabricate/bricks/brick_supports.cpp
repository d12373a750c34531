#include "snug/fabricate/bricks/brick_supports.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "snug/base/grid.h"

namespace snug {
namespace {

/// Of each cell of studs: how high its bricks reach, in plates; 0: none.
Grid<int> heights_of(const BrickBuild& build) {
    Grid<int> heights(build.rows, build.columns);
    for (const Brick& brick : build.bricks)
        for (int row = brick.row; row < brick.row + brick.rows; ++row)
            for (int column = brick.column; column < brick.column + brick.columns; ++column)
                heights(row, column) = std::max(heights(row, column), brick.top());
    return heights;
}

constexpr std::pair<int, int> kNeighbours[] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

/// The cells without bricks that lie outside the half, one ring around the grid included.
Grid<char> outside_of(const Grid<int>& heights) {
    const int rows = heights.ny() + 2, columns = heights.nz() + 2;
    Grid<char> outside(rows, columns);
    std::vector<std::pair<int, int>> open{{0, 0}};
    outside(0, 0) = 1;
    while (!open.empty()) {
        const auto [row, column] = open.back();
        open.pop_back();
        for (const auto& step : kNeighbours) {
            const int r = row + step.first, c = column + step.second;
            if (!outside.contains(r, c) || outside(r, c)) continue;
            if (heights.contains(r - 1, c - 1) && heights(r - 1, c - 1) > 0) continue;
            outside(r, c) = 1;
            open.emplace_back(r, c);
        }
    }
    return outside;
}

/// 1 where a cell with bricks lies beside the outside.
Grid<char> outline_of(const Grid<int>& heights) {
    const Grid<char> outside = outside_of(heights);
    Grid<char> outline(heights.ny(), heights.nz());
    for (int row = 0; row < heights.ny(); ++row)
        for (int column = 0; column < heights.nz(); ++column)
            if (heights(row, column) > 0)
                for (const auto& step : kNeighbours)
                    if (outside(row + 1 + step.first, column + 1 + step.second)) outline(row, column) = 1;
    return outline;
}

bool covers(const Brick& brick, const Grid<char>& cells) {
    for (int row = brick.row; row < brick.row + brick.rows; ++row)
        for (int column = brick.column; column < brick.column + brick.columns; ++column)
            if (cells(row, column)) return true;
    return false;
}

/// The top of the topmost layer that is filled all around.
int ring_top(const Grid<int>& heights, const Grid<char>& outline) {
    int top = 0;
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (outline[i]) top = top == 0 ? heights[i] : std::min(top, heights[i]);
    return top;
}

/// The height at which most of the outline ends.
int rim_height(const Grid<int>& heights, const Grid<char>& outline) {
    std::map<int, int> cells;
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (outline[i]) ++cells[heights[i]];
    int rim = 0, most = 0;
    for (const auto& [height, count] : cells)
        if (count >= most) rim = height, most = count;
    return rim;
}

}  // namespace

std::string_view brick_load_name(BrickLoad load) {
    switch (load) {
        case BrickLoad::lifted:
            return "lifted";
        case BrickLoad::turned:
            return "turned";
        case BrickLoad::standing:
            break;
    }
    return "standing";
}

BrickSupports brick_supports(const BrickBuild& build, const std::vector<BrickJoint>& joints, BrickLoad load) {
    const std::size_t count = build.bricks.size();
    BrickSupports supports{load, std::vector<char>(count), std::vector<char>(count)};
    if (load == BrickLoad::standing) {
        for (std::size_t i = 0; i < count; ++i) supports.resting[i] = build.bricks[i].bottom == 0;
        return supports;
    }
    const Grid<int> heights = heights_of(build);
    const Grid<char> outline = outline_of(heights);
    if (load == BrickLoad::lifted) {
        const int ring = ring_top(heights, outline);
        for (std::size_t i = 0; i < count; ++i) {
            const Brick& brick = build.bricks[i];
            supports.held[i] = brick.bottom < ring && brick.top() >= ring && covers(brick, outline);
        }
        return supports;
    }
    const int rim = rim_height(heights, outline);
    for (std::size_t i = 0; i < count; ++i) supports.resting[i] = build.bricks[i].top() == rim;
    for (const BrickJoint& joint : joints) supports.resting[joint.lower] = 0;
    return supports;
}

std::vector<int> loose_bricks(const BrickSupports& supports, const std::vector<BrickJoint>& joints) {
    const int count = static_cast<int>(supports.held.size());
    std::vector<int> leader(count);
    for (int i = 0; i < count; ++i) leader[i] = i;
    const auto find = [&](int i) {
        while (leader[i] != i) i = leader[i] = leader[leader[i]];
        return i;
    };
    for (const BrickJoint& joint : joints) leader[find(joint.upper)] = find(joint.lower);
    std::vector<char> tied(count);
    for (int i = 0; i < count; ++i)
        if (supports.held[i] || supports.resting[i]) tied[find(i)] = 1;
    std::vector<int> loose;
    for (int i = 0; i < count; ++i)
        if (!tied[find(i)]) loose.push_back(i);
    return loose;
}

bool rests_throughout(const BrickBuild& build, const std::vector<BrickJoint>& joints,
                      const BrickSupports& supports) {
    if (supports.load == BrickLoad::lifted) return build.bricks.empty();
    const bool turned = supports.load == BrickLoad::turned;
    std::vector<int> studs(build.bricks.size());
    for (const BrickJoint& joint : joints)
        studs[turned ? joint.lower : joint.upper] += joint.rows * joint.columns;
    for (std::size_t i = 0; i < studs.size(); ++i)
        if (!supports.resting[i] && studs[i] != build.bricks[i].studs()) return false;
    return true;
}

}  // namespace snug
