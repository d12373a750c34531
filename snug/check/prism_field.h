#pragma once

#include <limits>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/grid.h"
#include "snug/base/vec.h"
#include "snug/mesh/triangle_tree.h"

namespace snug {

/// Where a prism along x begins and ends, in mm; none where low > high.
struct PrismSpan {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool none() const { return low > high; }
};

/// The union of one prism along x over each cell of a regular y-z grid, such as the cut runs of a block map.
/// Finds the nearest point inside or outside it through a quadtree of bounds. Beyond the grid there are no
/// prisms.
class PrismField {
  public:
    /// Cell (j, k) reaches from y_begin + j * y_size to y_begin + (j + 1) * y_size, and so along z.
    PrismField(Grid<PrismSpan> spans, double y_begin, double y_size, double z_begin, double z_size);

    /// The box around all prisms; empty where there are none.
    [[nodiscard]] Box3d bounds() const;

    [[nodiscard]] bool contains(Vec3d p) const;

    /// The nearest point inside the union, not farther than `at_most`.
    [[nodiscard]] NearestPoint nearest_inside(Vec3d p, double at_most) const;

    /// The nearest point outside the union, not farther than `at_most`.
    [[nodiscard]] NearestPoint nearest_outside(Vec3d p, double at_most) const;

    /// Where the prism over p's y and z begins and ends.
    [[nodiscard]] PrismSpan span_at(Vec3d p) const;

  private:
    /// Of the spans below a node: the extremes of both ends.
    struct Bounds {
        double lowest_low, highest_high;  ///< nothing inside lies beyond these
        double highest_low, lowest_high;  ///< nothing outside lies between these
    };

    template <class OffsetAlongX>
    [[nodiscard]] NearestPoint nearest(Vec3d p, double at_most, OffsetAlongX offset) const;
    [[nodiscard]] Bounds bounds_of(int level, int j, int k) const;
    void build_level_above();

    Grid<PrismSpan> spans_;
    std::vector<Grid<Bounds>> levels_;  ///< levels_[0] has half as many cells along each axis as spans_
    double y_begin_, y_size_, z_begin_, z_size_;
};

}  // namespace snug
