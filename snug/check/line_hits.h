#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/check/line_lattice.h"

namespace snug {

/// The crossings of a rectangle of lines: mostly a row of columns (16 rows of lines) as broad as the space,
/// less where that many crossings would take too much memory.
struct LineBand {
    int first_row = 0, rows = 0;  ///< of the lattice
    int first_column = 0, columns = 0;
    std::vector<std::uint32_t> begin;  ///< where each line's crossings begin, row by row, and their end
    std::vector<Crossing> crossings;   ///< line by line, sorted by x, then by turn

    /// Whether any of the lines from (row, column) to (row, end_column - 1) of the lattice has a crossing.
    [[nodiscard]] bool any(int row, int column, int end_column) const {
        return begin[index(row, column)] != begin[index(row, end_column)];
    }

    /// The crossings of a line of the lattice.
    [[nodiscard]] std::span<const Crossing> line(int row, int column) const {
        const std::size_t i = index(row, column);
        return {crossings.data() + begin[i], crossings.data() + begin[i + 1]};
    }

    [[nodiscard]] int end_row() const { return first_row + rows; }
    [[nodiscard]] int end_column() const { return first_column + columns; }
    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column - first_column);
    }
};

/// Meets all lines of the lattice with the surface (vertices in design coordinates, or as lines see them),
/// one band after the other from -y to +y, and shows each band to `visit`. A band never divides the lines of
/// a column along z. Memory follows the mesh and one band, of about `most_hits` crossings at most. Triangles
/// seen edge-on along x are not met. Fails only when cancelled.
[[nodiscard]] Result<void> sweep_lines(const LineLattice& lattice, std::span<const SnappedVertex> vertices,
                                       std::span<const Triangle> triangles,
                                       const std::function<void(const LineBand&)>& visit,
                                       const Progress& progress = {},
                                       std::size_t most_hits = std::size_t{1} << 20);
[[nodiscard]] Result<void> sweep_lines(const LineLattice& lattice, std::span<const Vec3d> vertices,
                                       std::span<const Triangle> triangles,
                                       const std::function<void(const LineBand&)>& visit,
                                       const Progress& progress = {},
                                       std::size_t most_hits = std::size_t{1} << 20);

}  // namespace snug
