#include "snug/fabricate/bricks/laid_bricks.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace snug {

LaidBricks::LaidBricks(const std::vector<BrickCourse>& courses) : courses_(courses) {
    for (const BrickCourse& course : courses)
        owner_.emplace_back(course.cells.ny(), course.cells.nz(), kNone);
}

int LaidBricks::add(int course, const Brick& brick) {
    const int number = count();
    Grid<int>& owner = owner_[static_cast<std::size_t>(course)];
    for (int row = brick.row; row < brick.row + brick.rows; ++row)
        for (int column = brick.column; column < brick.column + brick.columns; ++column)
            owner(row, column) = number;
    bricks_.push_back(brick);
    course_of_.push_back(course);
    return number;
}

void LaidBricks::remove(int brick) {
    const Brick& old = (*this)[brick];
    Grid<int>& owner = owner_[static_cast<std::size_t>(course_of(brick))];
    for (int row = old.row; row < old.row + old.rows; ++row)
        for (int column = old.column; column < old.column + old.columns; ++column)
            if (owner(row, column) == brick) owner(row, column) = kNone;
    course_of_[static_cast<std::size_t>(brick)] = kNone;
}

int LaidBricks::at(int course, int row, int column) const {
    const Grid<int>& owner = owner_[static_cast<std::size_t>(course)];
    return owner.contains(row, column) ? owner(row, column) : kNone;
}

int LaidBricks::below(int course, int row, int column) const {
    const int bottom = courses_[static_cast<std::size_t>(course)].bottom;
    for (int c = course - 1; c >= 0 && bottom > 0; --c) {
        const BrickCourse& under = courses_[static_cast<std::size_t>(c)];
        if (under.top() == bottom && under.cells(row, column)) return at(c, row, column);
        if (under.bottom + 2 * kPlatesInBrick < bottom) break;
    }
    return kNone;
}

int LaidBricks::above(int course, int row, int column) const {
    const int top = courses_[static_cast<std::size_t>(course)].top();
    for (int c = course + 1; c < static_cast<int>(courses_.size()); ++c) {
        const BrickCourse& over = courses_[static_cast<std::size_t>(c)];
        if (over.bottom == top && over.cells(row, column)) return at(c, row, column);
        if (over.bottom > top) break;
    }
    return kNone;
}

std::pair<std::vector<int>, int> LaidBricks::pieces() const {
    std::vector<int> parent(bricks_.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int brick) {
        while (parent[static_cast<std::size_t>(brick)] != brick) {
            int& up = parent[static_cast<std::size_t>(brick)];
            up = parent[static_cast<std::size_t>(up)];
            brick = up;
        }
        return brick;
    };
    for (int i = 0; i < count(); ++i) {
        if (!is_there(i)) continue;
        const Brick& brick = (*this)[i];
        for (int row = brick.row; row < brick.row + brick.rows; ++row)
            for (int column = brick.column; column < brick.column + brick.columns; ++column) {
                const int under = below(course_of(i), row, column);
                if (under != kNone && (*this)[under].has_studs())
                    parent[static_cast<std::size_t>(root(i))] = root(under);
            }
    }
    std::vector<int> number(bricks_.size(), kNone), piece(bricks_.size(), kNone);
    int pieces = 0;
    for (int i = 0; i < count(); ++i) {
        if (!is_there(i)) continue;
        int& own = number[static_cast<std::size_t>(root(i))];
        if (own == kNone) own = pieces++;
        piece[static_cast<std::size_t>(i)] = own;
    }
    return {std::move(piece), pieces};
}

std::vector<Brick> LaidBricks::in_order() const {
    std::vector<int> order;
    for (int i = 0; i < count(); ++i)
        if (is_there(i)) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const Brick &x = (*this)[a], &y = (*this)[b];
        return std::tuple(course_of(a), x.row, x.column) < std::tuple(course_of(b), y.row, y.column);
    });
    std::vector<Brick> bricks;
    for (const int i : order) bricks.push_back((*this)[i]);
    return bricks;
}

}  // namespace snug
