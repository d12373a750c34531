#pragma once

#include <vector>

#include "snug/depth/depth_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// Indices first..last of neighbouring cells, both included; empty where first > last.
struct CellRange {
    int first = 0;
    int last = -1;
    friend bool operator==(CellRange, CellRange) = default;
};

/// The cells of the grid along one axis (y or z), each grown by the reach on both sides: they overlap where
/// the reach is positive and leave slots between them where it is negative.
class GrownCells {
  public:
    GrownCells(const DesignSpace& space, int axis, Reach reach);

    [[nodiscard]] int count() const { return static_cast<int>(low_.size()); }
    [[nodiscard]] double low(int cell) const { return low_[static_cast<std::size_t>(cell)]; }
    [[nodiscard]] double high(int cell) const { return high_[static_cast<std::size_t>(cell)]; }

    /// The cells that meet the interval from a to b (a <= b), bounds included.
    [[nodiscard]] CellRange meeting(double a, double b) const;
    [[nodiscard]] CellRange holding(double value) const { return meeting(value, value); }

    /// The only cell that holds the value. kNotOne where several or none do, and sometimes where the value
    /// lies within rounding of a cell's bounds.
    static constexpr int kNotOne = -1;
    [[nodiscard]] int sole(double value) const {
        const double cells = (value - start_) * cells_per_mm_;
        if (!(cells >= 0 && cells < count_)) return kNotOne;
        const int cell = static_cast<int>(cells);
        const Sole& sole = sole_[static_cast<std::size_t>(cell)];
        return value > sole.above && value < sole.below ? cell : kNotOne;
    }

  private:
    /// Values strictly between lie in this cell and in no other.
    struct Sole {
        double above;
        double below;
    };

    std::vector<double> low_;
    std::vector<double> high_;
    std::vector<Sole> sole_;
    double start_;
    double count_;
    double cells_per_mm_;
};

}  // namespace snug
