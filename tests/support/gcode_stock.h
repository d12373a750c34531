#pragma once

#include <string>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/vec.h"
#include "snug/base/vec2.h"

namespace snug::test {

/// One straight move that a program makes; a circle is many of them.
struct GcodeMove {
    bool rapid = false;
    Vec3d from, to;
    double feed = 0;  ///< mm a minute; 0 for rapid moves
};

/// A program as GRBL 1.1 reads it, by nothing of Snug's own.
struct GcodeProgram {
    std::vector<GcodeMove> moves;  ///< with the tool's end at X, Y, Z; the first begins at the first place
    std::vector<std::string> problems;  ///< words, numbers or lines that GRBL does not take
    bool spindle_on = false;
    bool ended = false;  ///< by M5 and M30
};
[[nodiscard]] GcodeProgram read_gcode(const std::string& text);

/// A stock of foam, X and Y from its near left corner, Z0 on top; heights above its underside in square
/// cells.
class GcodeStock {
  public:
    GcodeStock(Vec3d size_mm, double cell_mm);

    /// Lets a flat cutter go along the move; what lies under its middle part is judged at the cells' middles.
    void cut(const GcodeMove& move, double radius_mm);

    [[nodiscard]] const Grid<double>& height() const { return height_; }
    [[nodiscard]] Vec2d middle(int row, int column) const {
        return {(column + 0.5) * cell_, (row + 0.5) * cell_};
    }
    [[nodiscard]] double at(Vec2d mm) const;
    [[nodiscard]] double cell() const { return cell_; }

  private:
    double cell_, top_;
    Grid<double> height_;
};

}  // namespace snug::test
