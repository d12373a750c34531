#include "snug/depth/depth_builder.h"

#include <algorithm>
#include <limits>

namespace snug {
namespace {

// Cells that are further away are met by nothing, rounding included (mm).
constexpr double kMet = 2 * kCrossingError;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Calls f(x, y) for every point where an edge of the triangle crosses z = c.
template <class Call>
void for_each_crossing_of_z(const std::array<Vec3d, 3>& corners, double c, Call f) {
    const CrossedEdges crossed = crossed_edges({corners[0].z, corners[1].z, corners[2].z}, c);
    for (std::size_t i = 0; i < crossed.count; ++i) {
        const Vec3d& a = corners[crossed.edge[i]];
        const Vec3d& b = corners[next_corner(crossed.edge[i])];
        const double t = (c - a.z) / (b.z - a.z);
        f(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
    }
}

CellRange common(CellRange a, CellRange b) {
    return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

}  // namespace

DepthMapBuilder::DepthMapBuilder(const DesignSpace& space, Reach reach)
    : DepthMapBuilder(space, reach, DepthMap(space.blocks.y, space.blocks.z)) {}

DepthMapBuilder::DepthMapBuilder(const DesignSpace& space, Reach reach, DepthMap known)
    : rows_(space, 1, reach), columns_(space, 2, reach), depths_(std::move(known)) {}

// Inlined, these share what they look up: they are the heart of every plain depth map.

[[gnu::always_inline]] inline ColumnBlock DepthMapBuilder::block_of(
    const std::array<Vec3d, 3>& corners) const {
    const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto [z_min, z_max] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    // A cell more on each side: crossings may be rounded to just outside the triangle.
    const CellRange j = rows_.meeting(y_min, y_max), k = columns_.meeting(z_min, z_max);
    return {{std::max(j.first - 1, 0), std::min(j.last + 1, rows_.count() - 1)},
            {std::max(k.first - 1, 0), std::min(k.last + 1, columns_.count() - 1)}};
}

[[gnu::always_inline]] inline bool DepthMapBuilder::changes(int row, int column, double x_min,
                                                            double x_max) const {
    const DepthRange& depth = depths_(row, column);
    return x_max > depth.highest || x_min < depth.lowest;
}

[[gnu::always_inline]] inline CellRange DepthMapBuilder::changed_in_row(int row, CellRange columns,
                                                                        double x_min, double x_max) const {
    while (columns.first <= columns.last && !changes(row, columns.first, x_min, x_max)) ++columns.first;
    while (columns.first <= columns.last && !changes(row, columns.last, x_min, x_max)) --columns.last;
    return columns;
}

/// The triangle cut by the plane y = c is a segment; a cell's side at y = c sees the part of it between the
/// cell's two corners. Its ends are edge crossings or the points above those corners.
bool DepthMapBuilder::section_along_z(const std::array<Vec3d, 3>& corners, double c, Segment& segment) {
    const CrossedEdges crossed = crossed_edges({corners[0].y, corners[1].y, corners[2].y}, c);
    if (crossed.count < 2) return false;
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
    segment = {points[0], points[0]};
    for (std::size_t i = 1; i < crossed.count; ++i) {
        if (before(points[i], segment.first)) segment.first = points[i];
        if (before(segment.last, points[i])) segment.last = points[i];
    }
    return true;
}

[[gnu::always_inline]] inline void DepthMapBuilder::add_crossing(double x, double y, int column,
                                                                 CellRange rows) {
    for (int row = rows.first; row <= rows.last; ++row)
        if (rows_.high(row) >= y - kCrossingError && rows_.low(row) <= y + kCrossingError)
            depths_(row, column).include(x);
}

[[gnu::always_inline]] inline void DepthMapBuilder::add_in_block(const std::array<Vec3d, 3>& corners,
                                                                 const ColumnBlock& block, double x_min,
                                                                 double x_max) {
    const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto [z_min, z_max] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    for (int row = block.j.first; row <= block.j.last; ++row) {
        const CellRange k = changed_in_row(row, block.k, x_min, x_max);
        if (k.first > k.last) continue;
        for (const double c : {rows_.low(row), rows_.high(row)})
            if (Segment section; y_min <= c && c <= y_max && section_along_z(corners, c, section))
                add_segment(row, section, k);
    }
    for (int column = block.k.first; column <= block.k.last; ++column) {
        CellRange j = block.j;
        while (j.first <= j.last && !changes(j.first, column, x_min, x_max)) ++j.first;
        while (j.first <= j.last && !changes(j.last, column, x_min, x_max)) --j.last;
        if (j.first > j.last) continue;
        for (const double c : {columns_.low(column), columns_.high(column)})
            if (z_min <= c && c <= z_max) add_crossings_of_z(corners, column, c, j);
    }
}

/// The same for a part of a triangle, which crosses few of the lines.
void DepthMapBuilder::add_edges_within(const std::array<Vec3d, 3>& corners, const ColumnBlock& block) {
    for (int row = block.j.first; row <= block.j.last; ++row) {
        for (const double c : {rows_.low(row), rows_.high(row)}) {
            Segment section;
            if (!section_along_z(corners, c, section)) continue;
            const auto [x_min, x_max] = std::minmax(section.first.x, section.last.x);
            const CellRange met = columns_.meeting(section.first.along - kMet, section.last.along + kMet);
            add_segment(row, section, changed_in_row(row, common(block.k, met), x_min, x_max));
        }
    }
    for (int column = block.k.first; column <= block.k.last; ++column)
        for (const double c : {columns_.low(column), columns_.high(column)})
            for_each_crossing_of_z(corners, c, [&](double x, double y) {
                const CellRange met = rows_.meeting(y - kMet, y + kMet);
                add_crossing(x, y, column, common(block.j, met));
            });
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
        add_in_tiles(corners, block);
    else
        add_in_block(corners, block, x_min, x_max);
}

void DepthMapBuilder::add_in_tiles(const std::array<Vec3d, 3>& corners, const ColumnBlock& block) {
    if (tiles_.empty()) tiles_ = DepthTiles(rows_.count(), columns_.count());
    const SpreadTriangle triangle(corners);
    const ColumnBlock around = met_by(corners);
    const ColumnBlock met{common(block.j, around.j), common(block.k, around.k)};
    constexpr int kSide = DepthTiles::kSide;
    for (int tile_j = met.j.first / kSide; tile_j * kSide <= met.j.last; ++tile_j) {
        const CellRange rows{tile_j * kSide, std::min((tile_j + 1) * kSide, rows_.count()) - 1};
        for (int tile_k = met.k.first / kSide; tile_k * kSide <= met.k.last; ++tile_k) {
            const CellRange cells{tile_k * kSide, std::min((tile_k + 1) * kSide, columns_.count()) - 1};
            const SpreadTriangle::Rectangle seen = over({rows, cells});
            if (!triangle.may_meet(seen) || tiles_.hides(tile_j, tile_k, triangle, seen, depths_)) continue;
            add_in_tile(corners, triangle, {common(rows, met.j), common(cells, met.k)});
            tiles_.added(tile_j, tile_k, triangle, seen);
        }
    }
}

/// A tile in still smaller squares: most triangles change few of them.
void DepthMapBuilder::add_in_tile(const std::array<Vec3d, 3>& corners, const SpreadTriangle& triangle,
                                  const ColumnBlock& block) {
    constexpr int kSide = 8;
    for (int j = block.j.first; j <= block.j.last; j += kSide) {
        const CellRange rows{j, std::min(j + kSide - 1, block.j.last)};
        for (int k = block.k.first; k <= block.k.last; k += kSide) {
            const ColumnBlock square{rows, {k, std::min(k + kSide - 1, block.k.last)}};
            const SpreadTriangle::Rectangle seen = over(square);
            if (!triangle.may_meet(seen)) continue;
            const DepthRange x = triangle.over(seen);
            if (changes_any(square, x.lowest, x.highest)) add_edges_within(corners, square);
        }
    }
}

bool DepthMapBuilder::changes_any(const ColumnBlock& block, double x_min, double x_max) const {
    bool any = false;
    for (int row = block.j.first; row <= block.j.last; ++row)
        for (int column = block.k.first; column <= block.k.last; ++column)
            any |= changes(row, column, x_min, x_max);
    return any;
}

SpreadTriangle::Rectangle DepthMapBuilder::over(const ColumnBlock& block) const {
    return {rows_.low(block.j.first), rows_.high(block.j.last), columns_.low(block.k.first),
            columns_.high(block.k.last)};
}

ColumnBlock DepthMapBuilder::met_by(const std::array<Vec3d, 3>& corners) const {
    const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const auto [z_min, z_max] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
    return {rows_.meeting(y_min - kMet, y_max + kMet), columns_.meeting(z_min - kMet, z_max + kMet)};
}

void DepthMapBuilder::add_segment(int row, const Segment& segment, CellRange columns) {
    const auto [p, q] = segment;
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
    for_each_crossing_of_z(corners, c, [&](double x, double y) { add_crossing(x, y, column, rows); });
}

}  // namespace snug
