#include "snug/foam/depth_builder.h"

#include <algorithm>
#include <limits>

namespace snug {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

DepthMapBuilder::DepthMapBuilder(const DesignSpace& space, Reach reach)
    : rows_(space, 1, reach), columns_(space, 2, reach), depths_(space.blocks.y, space.blocks.z) {}

// Inlined, the next two share what they look up: they are the heart of every plain depth map.

[[gnu::always_inline]] inline ColumnBlock DepthMapBuilder::block_of(
    const std::array<Vec3d, 3>& corners) const {
    const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto [z_min, z_max] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    // A cell more on each side: crossings may be rounded to just outside the triangle.
    const CellRange j = rows_.meeting(y_min, y_max), k = columns_.meeting(z_min, z_max);
    return {{std::max(j.first - 1, 0), std::min(j.last + 1, rows_.count() - 1)},
            {std::max(k.first - 1, 0), std::min(k.last + 1, columns_.count() - 1)}};
}

[[gnu::always_inline]] inline void DepthMapBuilder::add_in_block(const std::array<Vec3d, 3>& corners,
                                                                 const ColumnBlock& block, double x_min,
                                                                 double x_max) {
    const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto [z_min, z_max] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    const auto changes = [&](int row, int column) {
        const DepthRange& depth = depths_(row, column);
        return x_max > depth.highest || x_min < depth.lowest;
    };
    for (int row = block.j.first; row <= block.j.last; ++row) {
        CellRange k = block.k;
        while (k.first <= k.last && !changes(row, k.first)) ++k.first;
        while (k.first <= k.last && !changes(row, k.last)) --k.last;
        if (k.first > k.last) continue;
        for (const double c : {rows_.low(row), rows_.high(row)})
            if (y_min <= c && c <= y_max) add_section_along_z(corners, row, c, k);
    }
    for (int column = block.k.first; column <= block.k.last; ++column) {
        CellRange j = block.j;
        while (j.first <= j.last && !changes(j.first, column)) ++j.first;
        while (j.first <= j.last && !changes(j.last, column)) --j.last;
        if (j.first > j.last) continue;
        for (const double c : {columns_.low(column), columns_.high(column)})
            if (z_min <= c && c <= z_max) add_crossings_of_z(corners, column, c, j);
    }
}

VertexCell DepthMapBuilder::add_vertex_of_several(Vec3d p) {
    const CellRange j = rows_.holding(p.y);
    const CellRange k = columns_.holding(p.z);
    for (int row = j.first; row <= j.last; ++row)
        for (int column = k.first; column <= k.last; ++column) depths_(row, column).include(p.x);
    const bool one = j.first == j.last && k.first == k.last;
    return one ? VertexCell{j.first, k.first} : VertexCell{};
}

void DepthMapBuilder::add_vertex(Vec3d p, const ColumnBlock& block) {
    for (int row = block.j.first; row <= block.j.last; ++row) {
        if (p.y < rows_.low(row) || p.y > rows_.high(row)) continue;
        for (int column = block.k.first; column <= block.k.last; ++column)
            if (p.z >= columns_.low(column) && p.z <= columns_.high(column))
                depths_(row, column).include(p.x);
    }
}

void DepthMapBuilder::add_triangle(const std::array<Vec3d, 3>& corners) {
    add_triangle(corners, block_of(corners), -kInfinity, kInfinity);
}

bool DepthMapBuilder::add_small_triangle(const std::array<Vec3d, 3>& corners) {
    const ColumnBlock block = block_of(corners);
    if (block.large()) return false;
    add_in_block(corners, block, -kInfinity, kInfinity);
    return true;
}

void DepthMapBuilder::add_triangle(const std::array<Vec3d, 3>& corners, const ColumnBlock& block,
                                   double x_min, double x_max) {
    if (block.large())
        add_in_tiles(corners, block, x_min, x_max);
    else
        add_in_block(corners, block, x_min, x_max);
}

void DepthMapBuilder::add_in_tiles(const std::array<Vec3d, 3>& corners, const ColumnBlock& block,
                                   double x_min, double x_max) {
    if (tiles_.empty()) tiles_ = DepthTiles(rows_.count(), columns_.count());
    const SpreadTriangle triangle(corners);
    constexpr int kSide = DepthTiles::kSide;
    for (int tile_j = block.j.first / kSide; tile_j * kSide <= block.j.last; ++tile_j) {
        const CellRange rows{tile_j * kSide, std::min((tile_j + 1) * kSide, rows_.count()) - 1};
        for (int tile_k = block.k.first / kSide; tile_k * kSide <= block.k.last; ++tile_k) {
            const CellRange cells{tile_k * kSide, std::min((tile_k + 1) * kSide, columns_.count()) - 1};
            const SpreadTriangle::Rectangle seen{rows_.low(rows.first), rows_.high(rows.last),
                                                 columns_.low(cells.first), columns_.high(cells.last)};
            if (!triangle.may_meet(seen) || tiles_.hides(tile_j, tile_k, triangle, seen)) continue;
            const DepthRange x = triangle.over(seen);
            add_in_block(corners,
                         {{std::max(rows.first, block.j.first), std::min(rows.last, block.j.last)},
                          {std::max(cells.first, block.k.first), std::min(cells.last, block.k.last)}},
                         std::max(x_min, x.lowest), std::min(x_max, x.highest));
            tiles_.added(tile_j, tile_k, triangle, seen, depths_);
        }
    }
}

/// The triangle cut by the plane y = c is a segment; a cell's side at y = c sees the part of it between the
/// cell's two corners. Its ends are edge crossings or the points above those corners.
void DepthMapBuilder::add_section_along_z(const std::array<Vec3d, 3>& corners, int row, double c,
                                          CellRange columns) {
    const CrossedEdges crossed = crossed_edges({corners[0].y, corners[1].y, corners[2].y}, c);
    if (crossed.count < 2) return;
    std::array<LinePoint, 3> points;
    for (std::size_t i = 0; i < crossed.count; ++i) {
        const Vec3d& a = corners[crossed.edge[i]];
        const Vec3d& b = corners[next_corner(crossed.edge[i])];
        const double t = (c - a.y) / (b.y - a.y);
        points[i] = {a.z + t * (b.z - a.z), a.x + t * (b.x - a.x)};
    }
    const auto before = [](LinePoint a, LinePoint b) {
        return a.along < b.along || (a.along == b.along && a.x < b.x);
    };
    LinePoint first = points[0], last = points[0];
    for (std::size_t i = 1; i < crossed.count; ++i) {
        if (before(points[i], first)) first = points[i];
        if (before(last, points[i])) last = points[i];
    }
    add_segment(row, first, last, columns);
}

void DepthMapBuilder::add_segment(int row, LinePoint p, LinePoint q, CellRange columns) {
    const auto [x_min, x_max] = std::minmax(p.x, q.x);
    for (int column = columns.first; column <= columns.last; ++column) {
        const double low = columns_.low(column);
        const double high = columns_.high(column);
        if (high < p.along - kCrossingError || low > q.along + kCrossingError) continue;
        double from = p.x, to = q.x;
        if (low > p.along || high < q.along) {
            const double slope = q.along > p.along ? (q.x - p.x) / (q.along - p.along) : 0;
            if (low > p.along) from = std::clamp(p.x + (low - p.along) * slope, x_min, x_max);
            if (high < q.along) to = std::clamp(p.x + (high - p.along) * slope, x_min, x_max);
        }
        depths_(row, column).include(from);
        depths_(row, column).include(to);
    }
}

/// Edges that cross a cell's side at z = c.
void DepthMapBuilder::add_crossings_of_z(const std::array<Vec3d, 3>& corners, int column, double c,
                                         CellRange rows) {
    const CrossedEdges crossed = crossed_edges({corners[0].z, corners[1].z, corners[2].z}, c);
    for (std::size_t i = 0; i < crossed.count; ++i) {
        const Vec3d& a = corners[crossed.edge[i]];
        const Vec3d& b = corners[next_corner(crossed.edge[i])];
        const double t = (c - a.z) / (b.z - a.z);
        const double x = a.x + t * (b.x - a.x);
        const double y = a.y + t * (b.y - a.y);
        for (int row = rows.first; row <= rows.last; ++row)
            if (rows_.high(row) >= y - kCrossingError && rows_.low(row) <= y + kCrossingError)
                depths_(row, column).include(x);
    }
}

}  // namespace snug
