#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/foam/line_lattice.h"

namespace snug {

/// The crossings of the lines through one row of columns (16 rows of lines).
struct LineBand {
    int j = 0;                         ///< the row of columns
    std::vector<std::uint32_t> begin;  ///< where each line's crossings begin, line by line, and their end
    std::vector<Crossing> crossings;   ///< line by line, sorted by x, then by turn
    int columns = 0;                   ///< lines in a row of lines

    /// Whether any line of row `l` (0 to 15) within the k-th column of the design space has a crossing.
    [[nodiscard]] bool any(int l, int k) const {
        const std::size_t i = index(l, k * LineLattice::kPerColumn);
        return begin[i] != begin[i + LineLattice::kPerColumn];
    }

    /// The crossings of the line in row `l` of the band (0 to 15) and `column` of the lattice.
    [[nodiscard]] std::span<const Crossing> line(int l, int column) const {
        const std::size_t i = index(l, column);
        return {crossings.data() + begin[i], crossings.data() + begin[i + 1]};
    }

  private:
    [[nodiscard]] std::size_t index(int l, int column) const {
        return static_cast<std::size_t>(l) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

/// Meets all lines of the lattice with the surface (vertices in design coordinates), one band after the other
/// from -y to +y, and shows each band to `visit`. Memory follows the mesh and one band. Triangles seen
/// edge-on along x are not met. Fails only when cancelled.
[[nodiscard]] Result<void> sweep_lines(const LineLattice& lattice, std::span<const Vec3d> vertices,
                                       std::span<const Triangle> triangles,
                                       const std::function<void(const LineBand&)>& visit,
                                       const Progress& progress = {});

}  // namespace snug
