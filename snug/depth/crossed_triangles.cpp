#include "snug/depth/crossed_triangles.h"

#include <algorithm>

#include "snug/depth/corner_crossings.h"

namespace snug {
CrossedTriangles::CrossedTriangles(const SurfaceClusters& surface, const ClusterPlacer& placer, double slack,
                                   DepthMapBuilder& builder)
    : surface_(surface),
      placer_(placer),
      builder_(builder),
      slack_(slack),
      rows_(builder.rows().count()),
      cells_(builder.columns().count()) {
    const auto last_row = static_cast<std::int16_t>(rows_ - 1);
    const auto last_cell = static_cast<std::int16_t>(cells_ - 1);
    least_ =
        CellBounds::Lanes{0, 0, static_cast<std::int16_t>(~last_row), static_cast<std::int16_t>(~last_cell)};
    most_ = CellBounds::Lanes{last_row, last_cell, -1, -1};
}

ColumnBlock CrossedTriangles::block(CellBounds cells) const {
    return {{std::max(cells.first_j(), 0), std::min(cells.last_j(), rows_ - 1)},
            {std::max(cells.first_k(), 0), std::min(cells.last_k(), cells_ - 1)}};
}

void CrossedTriangles::add(const SurfaceClusters::Cluster& cluster, const PlacedCluster& placed) {
    // Lists made without branches, since which triangles are crossed and which of those matter is hard to
    // predict.
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
    std::array<Corners, SurfaceClusters::kTriangles> matter;
    std::size_t matter_count = 0;
    for (std::size_t n = 0; n < count; ++n) {
        const auto [i, j, k] = corners[crossed[n]];
        const double a = placed.x[i], b = placed.x[j], c = placed.x[k];
        Corners& t = matter[matter_count];
        t = {
            {i, j, k}, bounds[n], std::min(std::min(a, b), c) - slack_, std::max(std::max(a, b), c) + slack_};
        matter_count += may_change(t);
    }
    for (std::size_t n = 0; n < matter_count; ++n) {
        const Corners& t = matter[n];
        const ColumnBlock columns = block(t.cells);
        // Counted with what lies beyond the grid, where a triangle crosses more sides.
        const int more_rows = t.cells.last_j() - t.cells.first_j();
        const int more_cells = t.cells.last_k() - t.cells.first_k();
        const bool inside = columns.j == CellRange{t.cells.first_j(), t.cells.last_j()} &&
                            columns.k == CellRange{t.cells.first_k(), t.cells.last_k()};
        if (inside && more_rows == 1 && more_cells == 1)
            add_around_corner(cluster, t, columns);
        else if (inside && more_rows + more_cells == 1)
            add_beside_side(cluster, placed, t, columns);
        else
            builder_.add_triangle(placed_corners(cluster, t), columns, t.x_min, t.x_max);
    }
}

bool CrossedTriangles::may_change(const Corners& t) const {
    // Triangles outside the grid are taken for ones at its edge: they are few.
    const CellBounds cells = t.cells.clamped(least_, most_);
    const int more_rows = cells.last_j() - cells.first_j(), more_cells = cells.last_k() - cells.first_k();
    const auto first = static_cast<std::size_t>(cells.first_j() * cells_ + cells.first_k());
    const auto last = static_cast<std::size_t>(cells.last_j() * cells_ + cells.last_k());
    if (changes(t, first) + changes(t, last) + (more_rows + more_cells > 2) > 0) return true;
    const auto across = static_cast<std::size_t>(more_cells);
    return more_rows * more_cells > 0 && changes(t, first + across) + changes(t, last - across) > 0;
}

void CrossedTriangles::add_beside_side(const SurfaceClusters::Cluster& cluster, const PlacedCluster& placed,
                                       const Corners& t, const ColumnBlock& block) {
    const bool along_y = block.k.first == block.k.last;
    const GrownCells& cells = along_y ? builder_.rows() : builder_.columns();
    const int first = along_y ? block.j.first : block.k.first;
    const auto [a, b, c] = t.vertex;
    const int axis = along_y ? 1 : 2;
    const std::array<double, 3> u{placer_.coordinate(cluster, a, axis), placer_.coordinate(cluster, b, axis),
                                  placer_.coordinate(cluster, c, axis)};
    std::array<DepthRange, 2> found;
    if (!extremes_beside_side(u, {placed.x[a], placed.x[b], placed.x[c]},
                              {cells.high(first), cells.low(first + 1)}, found))
        return builder_.add_triangle(placed_corners(cluster, t));
    DepthMap& depths = builder_.depths();
    depths(block.j.first, block.k.first).include(found[0]);
    depths(block.j.last, block.k.last).include(found[1]);
}

void CrossedTriangles::add_around_corner(const SurfaceClusters::Cluster& cluster, const Corners& t,
                                         const ColumnBlock& block) {
    const GrownCells &rows = builder_.rows(), &cells = builder_.columns();
    const auto corners = placed_corners(cluster, t);
    std::array<DepthRange, 4> found;
    if (!extremes_around_corner(corners,
                                {rows.high(block.j.first), rows.low(block.j.last), cells.high(block.k.first),
                                 cells.low(block.k.last)},
                                found))
        return builder_.add_triangle(corners);
    DepthMap& depths = builder_.depths();
    depths(block.j.first, block.k.first).include(found[0]);
    depths(block.j.first, block.k.last).include(found[1]);
    depths(block.j.last, block.k.first).include(found[2]);
    depths(block.j.last, block.k.last).include(found[3]);
}

std::array<Vec3d, 3> CrossedTriangles::placed_corners(const SurfaceClusters::Cluster& cluster,
                                                      const Corners& t) const {
    return {placer_.vertex(cluster, t.vertex[0]), placer_.vertex(cluster, t.vertex[1]),
            placer_.vertex(cluster, t.vertex[2])};
}

}  // namespace snug
