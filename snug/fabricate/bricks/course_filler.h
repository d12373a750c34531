#pragma once

#include <vector>

#include "snug/fabricate/bricks/brick_courses.h"
#include "snug/fabricate/bricks/brick_layout.h"

namespace snug {

/// How a course is filled: which way its bricks run and where their joints lie.
struct Bond {
    bool along_rows = true;  ///< long bricks run to the right, else towards the viewer
    bool by_size = true;     ///< all of the largest size first; else cell by cell the largest that fits
    int long_shift = 0;      ///< quarters of a brick's length by which its joints are shifted
    int short_shift = 0;     ///< studs across
};

/// Puts pieces into free cells of a course.
class CourseFiller {
  public:
    /// References live as long as the filler. `free`: cells to be filled, a part of the course's.
    CourseFiller(const BrickCourse& course, Grid<char> free);

    /// Takes a piece out of `entries` and puts it there.
    void place(BrickBox::Entry& entry, int row, int column, int rows, int columns);
    [[nodiscard]] bool fits(int row, int column, int rows, int columns) const;

    /// Fills what is free with what the entries (largest first) have left; foam without support first, by
    /// pieces that reach over it. Cells that nothing fits stay free.
    void fill(std::vector<BrickBox::Entry>& entries, const Bond& bond);

    [[nodiscard]] const std::vector<Brick>& bricks() const { return bricks_; }
    [[nodiscard]] int unfilled() const { return unfilled_; }

  private:
    void fill_by_size(std::vector<BrickBox::Entry>& entries, const Bond& bond);
    void fill_cell_by_cell(std::vector<BrickBox::Entry>& entries, const Bond& bond);
    void span(std::vector<BrickBox::Entry>& entries);
    void span_from(std::vector<BrickBox::Entry>& entries, int row, int column);
    void lay(BrickBox::Entry& entry, bool along_rows, const Bond& bond, bool on_lattice);
    [[nodiscard]] int supported_in(int row, int column, int rows, int columns) const;
    void update_runs(int row, int last_column);

    const BrickCourse& course_;
    Grid<int> run_;  ///< free cells from here to the right
    std::vector<Brick> bricks_;
    int unfilled_ = 0;
};

}  // namespace snug
