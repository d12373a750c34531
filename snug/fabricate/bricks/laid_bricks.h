#pragma once

#include <utility>
#include <vector>

#include "snug/fabricate/bricks/brick_courses.h"

namespace snug {

/// Bricks of a half while they are laid: which one is where, in every course.
class LaidBricks {
  public:
    /// Of a brick that was taken away.
    static constexpr int kNone = -1;

    explicit LaidBricks(const std::vector<BrickCourse>& courses);

    int add(int course, const Brick& brick);
    void remove(int brick);

    [[nodiscard]] int count() const { return static_cast<int>(bricks_.size()); }  ///< with those taken away
    [[nodiscard]] int course_of(int brick) const { return course_of_[static_cast<std::size_t>(brick)]; }
    [[nodiscard]] bool is_there(int brick) const { return course_of(brick) != kNone; }
    [[nodiscard]] const Brick& operator[](int brick) const {
        return bricks_[static_cast<std::size_t>(brick)];
    }
    /// Which brick of the course has this stud; kNone outside and where it has none.
    [[nodiscard]] int at(int course, int row, int column) const;
    /// Which brick is right below this stud of the course.
    [[nodiscard]] int below(int course, int row, int column) const;
    [[nodiscard]] int above(int course, int row, int column) const;

    /// For each brick the number of the piece that it belongs to, joined by studs; kNone where it was taken
    /// away. Also how many pieces there are.
    [[nodiscard]] std::pair<std::vector<int>, int> pieces() const;

    /// In the order of building: course after course, in each from the far left.
    [[nodiscard]] std::vector<Brick> in_order() const;

  private:
    const std::vector<BrickCourse>& courses_;
    std::vector<Grid<int>> owner_;
    std::vector<Brick> bricks_;
    std::vector<int> course_of_;
};

}  // namespace snug
