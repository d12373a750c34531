#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/space/design_space.h"

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

/// Lines along x. The cells of a regular y-z grid over the design space hold one line each: 16 x 16 cells a
/// column, or, where that would be too much work (line_budget.h), 8 x 8, 4 x 4 ... and then one for 2 x 2
/// columns, 4 x 4 ... Within its cell (l, m) a line stands m + 1/2 and l + 1/2 sixteenths of the way along y
/// and z (the canonical arrangement of correlated multi-jittered sampling, Kensler 2013): so the 256 lines of
/// 16 x 16 cells have 256 different y and 256 different z, and a wall parallel to an axis is measured to
/// 1/512 of a column, not 1/32.
class LineLattice {
  public:
    static constexpr int kPerColumn = 16;       ///< cells and lines per column and axis, at most and normally
    static constexpr int kUnitsPerCell = 4096;  ///< of such cells; y and z of vertices snap to whole units
    static constexpr int kFinest = 12;          ///< `cell_bits` of such cells
    static constexpr int kCoarsest = 28;        ///< one line for all

    /// `cell_bits`: a cell's side is 2^cell_bits units.
    explicit LineLattice(const DesignSpace& space, int cell_bits = kFinest);

    [[nodiscard]] int rows() const { return along_y_.cells; }     ///< along y
    [[nodiscard]] int columns() const { return along_z_.cells; }  ///< along z
    [[nodiscard]] int cell_bits() const { return bits_; }

    /// Lines per column and axis; 1 also where one line stands for several columns.
    [[nodiscard]] int lines_along_column() const { return 1 << std::max(kColumnBits - bits_, 0); }
    /// Columns along an axis that a line stands for; 1 also where a column has several.
    [[nodiscard]] int columns_along_cell() const { return 1 << std::max(bits_ - kColumnBits, 0); }
    /// 256, 64, 16, 4, 1, 1/4 ...
    [[nodiscard]] double lines_per_column() const;

    /// The position of a line in units.
    [[nodiscard]] std::int32_t u(int row, int column) const { return along_y_.line(bits_, row, column); }
    [[nodiscard]] std::int32_t v(int row, int column) const { return along_z_.line(bits_, column, row); }

    /// The column of the design space that a line runs through: j along y, k along z.
    [[nodiscard]] int j(int row, int column) const { return u(row, column) >> kColumnBits; }
    [[nodiscard]] int k(int row, int column) const { return v(row, column) >> kColumnBits; }

    /// How much of a line's cell lies in the design space: 1, but for the last of cells larger than a column.
    [[nodiscard]] double share(int row, int column) const;

    /// A point in design coordinates. What lies thousands of columns away from the space is moved closer.
    [[nodiscard]] SnappedVertex snap(Vec3d p) const;

    [[nodiscard]] double mm_per_unit_y() const { return 1 / units_per_mm_y_; }
    [[nodiscard]] double mm_per_unit_z() const { return 1 / units_per_mm_z_; }

  private:
    static constexpr int kColumnBits = 16;  ///< a column's side is 2^16 units

    /// The cells along one axis.
    struct Axis {
        int cells;
        std::int32_t last;  ///< units of the last cell that lie in the space

        [[nodiscard]] std::int32_t extent(int bits, int cell) const {
            return cell + 1 == cells ? last : 1 << bits;
        }
        [[nodiscard]] std::int32_t line(int bits, int cell, int other) const {
            const auto thirty_seconds = static_cast<std::int64_t>(2 * (other % kPerColumn) + 1);
            return (cell << bits) +
                   static_cast<std::int32_t>(thirty_seconds * extent(bits, cell) / (2 * kPerColumn));
        }
    };
    static Axis axis(int columns, int bits);

    int bits_;
    Axis along_y_;
    Axis along_z_;
    double y_begin_;
    double z_begin_;
    double units_per_mm_y_;
    double units_per_mm_z_;
};

/// The same of many points, for every lattice of one space: how fine it is does not matter.
[[nodiscard]] std::vector<SnappedVertex> snapped(const LineLattice& lattice, std::span<const Vec3d> points);

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
