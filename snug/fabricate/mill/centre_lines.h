#pragma once

#include <vector>

#include "snug/fabricate/mill/mill_field.h"

namespace snug {

/// From `begin` to `end` along a line, mm.
struct Stretch {
    double begin = 0, end = 0;
};

/// Where the middle of a flat cutter may be while its end is at `level` (steps): no nearer than its radius to
/// any column that is to stay higher, and no farther beyond the stock's edges, where narrow strips are
/// cleared from. Exact: the foam's columns grown by a disc, line by line.
class CentreLines {
  public:
    /// The field must live as long.
    CentreLines(const MillField& field, int level, double radius_mm);

    /// Stretches of the line at this y, along x, in ascending order; of length 0 where there is just room.
    [[nodiscard]] std::vector<Stretch> along_x(double y) const { return along(rows_, y, x_); }
    /// Stretches of the line at this x, along y.
    [[nodiscard]] std::vector<Stretch> along_y(double x) const { return along(columns_, x, y_); }
    /// Whether the cutter may go straight from one place to the other.
    [[nodiscard]] bool free(Vec2d from, Vec2d to) const;

    [[nodiscard]] int level() const { return level_; }
    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] const MillField& field() const { return field_; }

  private:
    /// Runs of higher columns in each row (or column), in cells.
    struct Run {
        int begin, end;
    };
    using Runs = std::vector<std::vector<Run>>;
    struct Axis {
        double cell, length;
    };
    /// `across` has the cells' width across the line; the line runs along `axis`.
    [[nodiscard]] std::vector<Stretch> along(const Runs& runs, double at, const Axis& axis) const;

    const MillField& field_;
    int level_;
    double radius_;
    Axis x_, y_;
    Runs rows_, columns_;
};

}  // namespace snug
