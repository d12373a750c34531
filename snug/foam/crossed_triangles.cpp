#include "snug/foam/crossed_triangles.h"

#include <algorithm>

namespace snug {
CrossedTriangles::CrossedTriangles(const SurfaceClusters& surface, const ClusterPlacer& placer, double slack,
                                   DepthMapBuilder& builder)
    : surface_(surface),
      placer_(placer),
      builder_(builder),
      slack_(slack),
      rows_(builder.rows().count()),
      cells_(builder.columns().count()) {}

ColumnBlock CrossedTriangles::block(CellBounds cells) const {
    return {{std::max(cells.first_j(), 0), std::min(cells.last_j(), rows_ - 1)},
            {std::max(cells.first_k(), 0), std::min(cells.last_k(), cells_ - 1)}};
}

void CrossedTriangles::add(const SurfaceClusters::Cluster& cluster, const PlacedCluster& placed) {
    // A list made without branches, since which triangles are crossed is hard to predict.
    std::array<CellBounds, SurfaceClusters::kTriangles> bounds;
    std::array<std::uint8_t, SurfaceClusters::kTriangles> crossed;
    std::size_t count = 0;
    const auto* const corners = surface_.corners.data() + cluster.first_triangle;
    for (std::size_t t = 0; t < cluster.triangles; ++t) {
        const auto [i, j, k] = corners[t];
        const CellBounds cells = placed.cells[i].merged(placed.cells[j]).merged(placed.cells[k]);
        crossed[count] = static_cast<std::uint8_t>(t);
        bounds[count] = cells;
        count += cells.several();
    }
    for (std::size_t n = 0; n < count; ++n) {
        const auto [i, j, k] = corners[crossed[n]];
        Corners t{{i, j, k}, {placed.x[i], placed.x[j], placed.x[k]}, 0, 0};
        t.x_min = std::min({t.x[0], t.x[1], t.x[2]}) - slack_;
        t.x_max = std::max({t.x[0], t.x[1], t.x[2]}) + slack_;
        const bool one_cell = bounds[n].first_k() == bounds[n].last_k();
        const bool one_row = bounds[n].first_j() == bounds[n].last_j();
        const ColumnBlock columns = block(bounds[n]);
        if (!(one_cell | one_row)) {
            add_in_block(cluster, t, columns);
            continue;
        }
        const Strip strip = one_cell ? Strip{1, columns.j, columns.k.first, cells_}
                                     : Strip{2, columns.k, columns.j.first * cells_, 1};
        const auto [first, last] = strip.cells;
        const int may = changes(t, static_cast<std::size_t>(strip.first + first * strip.step)) +
                        changes(t, static_cast<std::size_t>(strip.first + last * strip.step));
        if (may + (last - first > 1) > 0) add_in_strip(cluster, t, strip);
    }
}

// A triangle that stays well inside a row of cells (or one across): its section with a line between two of
// them lies within one cell, so the ends of the section are all that counts. The same operations as in
// DepthMapBuilder, edge by edge in the triangle's order.
void CrossedTriangles::add_in_strip(const SurfaceClusters::Cluster& cluster, const Corners& t,
                                    const Strip& strip) {
    const std::array<double, 3> u{placer_.coordinate(cluster, t.vertex[0], strip.axis),
                                  placer_.coordinate(cluster, t.vertex[1], strip.axis),
                                  placer_.coordinate(cluster, t.vertex[2], strip.axis)};
    const double u_min = std::min({u[0], u[1], u[2]}), u_max = std::max({u[0], u[1], u[2]});
    const GrownCells& cells = strip.axis == 1 ? builder_.rows() : builder_.columns();
    for (int cell = strip.cells.first; cell <= strip.cells.last; ++cell) {
        const auto column = static_cast<std::size_t>(strip.first + cell * strip.step);
        if (!changes(t, column)) continue;
        DepthRange& depth = builder_.depths()[column];
        for (const double side : {cells.low(cell), cells.high(cell)}) {
            if (side < u_min || side > u_max) continue;
            const CrossedEdges crossed = crossed_edges(u, side);
            // A corner on the line has two edges that need not give it the same x.
            if (crossed.count != 2) return builder_.add_triangle(placed_corners(cluster, t));
            for (std::size_t i = 0; i < 2; ++i) {
                const std::size_t a = crossed.edge[i], b = next_corner(a);
                depth.include(t.x[a] + (side - u[a]) / (u[b] - u[a]) * (t.x[b] - t.x[a]));
            }
        }
    }
}

void CrossedTriangles::add_in_block(const SurfaceClusters::Cluster& cluster, const Corners& t,
                                    const ColumnBlock& block) {
    for (int j = block.j.first; j <= block.j.last; ++j) {
        for (int k = block.k.first; k <= block.k.last; ++k) {
            if (!changes(t, builder_.depths().index(j, k))) continue;
            return builder_.add_triangle(placed_corners(cluster, t), block, t.x_min, t.x_max);
        }
    }
}

std::array<Vec3d, 3> CrossedTriangles::placed_corners(const SurfaceClusters::Cluster& cluster,
                                                      const Corners& t) const {
    return {placer_.vertex(cluster, t.vertex[0]), placer_.vertex(cluster, t.vertex[1]),
            placer_.vertex(cluster, t.vertex[2])};
}

}  // namespace snug
