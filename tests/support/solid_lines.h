#pragma once

#include <array>
#include <vector>

#include "snug/base/vec.h"

namespace snug::test {

using Corners = std::array<Vec3d, 3>;

/// Where lines along an axis meet a surface, by nothing but triangles: a square grid of count x count lines,
/// each in the middle of its cell of the rectangle from `low` to `high` (of which the axis itself is not
/// looked at). Crossings of a line rise.
class SolidLines {
  public:
    SolidLines(const std::vector<Corners>& triangles, int axis, int count, Vec3d low, Vec3d high);

    [[nodiscard]] const std::vector<double>& at(int i, int k) const {
        return crossings_[static_cast<std::size_t>(i) * static_cast<std::size_t>(count_) +
                          static_cast<std::size_t>(k)];
    }
    /// The length of the line inside the surface between two places.
    [[nodiscard]] double inside(int i, int k, double from, double to) const;

  private:
    int count_;
    std::vector<std::vector<double>> crossings_;
};

}  // namespace snug::test
