#include "snug/check/line_budget.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace snug {
namespace {

/// How far a surface reaches, seen along x, within the design space.
struct Shadow {
    double area = 0;    ///< of all triangles, square units
    double height = 0;  ///< along y, of all triangles, units
};

/// The part of the interval between 0 and `end`.
double within(std::int32_t low, std::int32_t high, double end) {
    return std::max(std::min<double>(high, end) - std::max<double>(low, 0), 0.0);
}

Shadow shadow_of(const DesignSpace& space, std::span<const SnappedVertex> vertices,
                 std::span<const Triangle> triangles) {
    constexpr double kColumn = LineLattice::kPerColumn * LineLattice::kUnitsPerCell;
    const double u_end = space.blocks.y * kColumn, v_end = space.blocks.z * kColumn;
    Shadow shadow;
    for (const Triangle& t : triangles) {
        const SnappedVertex &a = vertices[t[0]], &b = vertices[t[1]], &c = vertices[t[2]];
        const double area = std::fabs(static_cast<double>(doubled_shadow(a, b, c))) / 2;
        if (area == 0) continue;
        const double height = within(std::min({a.u, b.u, c.u}), std::max({a.u, b.u, c.u}), u_end);
        const double breadth = within(std::min({a.v, b.v, c.v}), std::max({a.v, b.v, c.v}), v_end);
        shadow.area += std::min(area, height * breadth);
        shadow.height += height;
    }
    return shadow;
}

}  // namespace

LineLattice lattice_within(const LineBudget& budget, const DesignSpace& space,
                           std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
    return lattice_within(budget, space, snapped(LineLattice(space), vertices), triangles);
}

LineLattice lattice_within(const LineBudget& budget, const DesignSpace& space,
                           std::span<const SnappedVertex> vertices, std::span<const Triangle> triangles) {
    const Shadow shadow = shadow_of(space, vertices, triangles);
    for (int bits = LineLattice::kFinest;; ++bits) {
        const LineLattice lattice(space, bits);
        const double cell = 1 << bits;
        const bool few_lines = static_cast<double>(lattice.rows()) * lattice.columns() <= budget.lines;
        const bool few_hits = shadow.area / cell / cell + shadow.height / cell <= budget.hits;
        if ((few_lines && few_hits) || bits == LineLattice::kCoarsest) return lattice;
    }
}

}  // namespace snug
