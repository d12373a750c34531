#pragma once

#include <span>

#include "snug/base/vec.h"
#include "snug/check/line_lattice.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"

namespace snug {

/// How much work lines may be. Objects that people pack take a hundredth of it in blocks of the usual size.
struct LineBudget {
    double lines = 1 << 24;  ///< 256 a column in 256 x 256 columns, and one a column in 4096 x 4096
    double hits = 1 << 24;   ///< crossings with triangles, and rows of lines that triangles reach into
};

/// The finest lattice whose lines stay within the budget (16 x 16 lines a column wherever they do), for a
/// surface in design coordinates, or as lines see it. The same on every machine.
[[nodiscard]] LineLattice lattice_within(const LineBudget& budget, const DesignSpace& space,
                                         std::span<const SnappedVertex> vertices,
                                         std::span<const Triangle> triangles);
[[nodiscard]] LineLattice lattice_within(const LineBudget& budget, const DesignSpace& space,
                                         std::span<const Vec3d> vertices,
                                         std::span<const Triangle> triangles);

}  // namespace snug
