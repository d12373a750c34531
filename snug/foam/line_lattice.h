#pragma once

#include <cstdint>
#include <optional>

#include "snug/base/vec.h"
#include "snug/foam/design_space.h"

namespace snug {

/// A vertex as the lines see it: y and z snapped to whole units of the lattice, x in mm.
struct SnappedVertex {
    std::int32_t u = 0;  ///< along y
    std::int32_t v = 0;  ///< along z
    double x = 0;
};

/// Where a line along x meets the surface.
struct Crossing {
    double x = 0;
    int turn = 0;  ///< how the winding number changes as x grows: +1 where the surface faces -x, -1 where +x
};

/// Lines along x, 16 x 16 a column: each column is divided into 16 x 16 equal cells, one line a cell. Within
/// its cell (l, m) a line stands m + 1/2 and l + 1/2 sixteenths of the way along y and z (the canonical
/// arrangement of correlated multi-jittered sampling, Kensler 2013): so the 256 lines of a column have 256
/// different y and 256 different z, and a wall parallel to an axis is measured to 1/512 of a column, not
/// 1/32.
class LineLattice {
  public:
    static constexpr int kPerColumn = 16;  ///< cells and lines per column and axis
    static constexpr int kUnitsPerCell =
        4096;  ///< y and z of vertices snap to this fraction of a line's cell

    explicit LineLattice(const DesignSpace& space);

    [[nodiscard]] int rows() const { return rows_; }        ///< along y, 16 a column
    [[nodiscard]] int columns() const { return columns_; }  ///< along z, 16 a column

    /// The position of a line in units.
    [[nodiscard]] std::int32_t u(int row, int column) const { return row * kUnitsPerCell + within(column); }
    [[nodiscard]] std::int32_t v(int row, int column) const { return column * kUnitsPerCell + within(row); }

    /// A point in design coordinates. What lies thousands of columns away from the space is moved closer.
    [[nodiscard]] SnappedVertex snap(Vec3d p) const;

    [[nodiscard]] double mm_per_unit_y() const { return 1 / units_per_mm_y_; }
    [[nodiscard]] double mm_per_unit_z() const { return 1 / units_per_mm_z_; }

  private:
    static std::int32_t within(int other) {
        constexpr int kStep = kUnitsPerCell / kPerColumn;
        return (other % kPerColumn) * kStep + kStep / 2;
    }

    int rows_;
    int columns_;
    double y_begin_;
    double z_begin_;
    double units_per_mm_y_;
    double units_per_mm_z_;
};

/// Twice the area of a triangle's shadow on the y-z plane, in squared units: positive where it faces +x.
/// Exact.
[[nodiscard]] std::int64_t doubled_shadow(const SnappedVertex& a, const SnappedVertex& b,
                                          const SnappedVertex& c);

/// Where the line at (u, v) meets the triangle, if it does. Exact in y and z: of the triangles around an edge
/// or a vertex that the line runs through, it meets just those that it would meet if it stood a trifle
/// further along -y (and a far smaller one along +z). So lines through a closed surface always come out
/// again.
[[nodiscard]] std::optional<Crossing> crossing(std::int32_t u, std::int32_t v, const SnappedVertex& a,
                                               const SnappedVertex& b, const SnappedVertex& c);

}  // namespace snug
