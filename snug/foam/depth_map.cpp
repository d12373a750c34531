#include "snug/foam/depth_map.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "snug/foam/cells.h"

// The surface inside one grown cell is a set of polygons: triangles clipped to the cell. The extremes of x
// over such a polygon lie at its corners, and those are of three kinds: the triangle's own vertices, points
// where its edges cross the cell's sides, and points above the cell's corners. Each kind is found without
// clipping: vertices one by one, and the other two on the lines that bound the cells.

namespace snug {
namespace {

constexpr double kFaceTolerance = 0.01;
constexpr double kRounding = 1e-9;
// A computed crossing may be rounded to just outside the cell whose side it was computed on, and an edge
// through a cell's corner must not be lost on both sides that meet there. Well below kRounding, well above a
// double's error.
constexpr double kCrossingError = 1e-10;

class DepthMapBuilder {
  public:
    DepthMapBuilder(const DesignSpace& space, Reach reach)
        : rows_(space, 1, reach), columns_(space, 2, reach), depths_(space.blocks.y, space.blocks.z) {}

    void add_vertex(Vec3d p, CellRange j, CellRange k) {
        for (int row = j.first; row <= j.last; ++row) include(row, k, p.x);
    }

    void add_triangle(const std::array<Vec3d, 3>& corners) {
        const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const auto [z_min, z_max] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
        const CellRange j = rows_.meeting(y_min, y_max);
        const CellRange k = columns_.meeting(z_min, z_max);
        for (int row = j.first; row <= j.last; ++row) {
            add_section_along_z(corners, row, rows_.low(row));
            add_section_along_z(corners, row, rows_.high(row));
        }
        for (int column = k.first; column <= k.last; ++column) {
            add_crossings_of_z(corners, column, columns_.low(column));
            add_crossings_of_z(corners, column, columns_.high(column));
        }
    }

    [[nodiscard]] const GrownCells& rows() const { return rows_; }
    [[nodiscard]] const GrownCells& columns() const { return columns_; }
    [[nodiscard]] DepthMap take() { return std::move(depths_); }

  private:
    /// A point of a triangle on a line of constant y or z: where it is along the line, and its x.
    struct LinePoint {
        double along;
        double x;
    };

    void include(int j, CellRange k, double x) {
        for (int column = k.first; column <= k.last; ++column) depths_(j, column).include(x);
    }

    /// The triangle cut by the plane y = c is a segment; a cell's side at y = c sees the part of it between
    /// the cell's two corners. Its ends are edge crossings or the points above those corners.
    void add_section_along_z(const std::array<Vec3d, 3>& corners, int row, double c) {
        std::array<LinePoint, 3> points{};
        int found = 0;
        for (int i = 0; i < 3; ++i) {
            const Vec3d& a = corners[static_cast<std::size_t>(i)];
            const Vec3d& b = corners[static_cast<std::size_t>((i + 1) % 3)];
            if (a.y == b.y || std::min(a.y, b.y) > c || std::max(a.y, b.y) < c) continue;
            const double t = (c - a.y) / (b.y - a.y);
            points[static_cast<std::size_t>(found++)] = {a.z + t * (b.z - a.z), a.x + t * (b.x - a.x)};
        }
        if (found < 2) return;
        const auto before = [](LinePoint a, LinePoint b) {
            return a.along < b.along || (a.along == b.along && a.x < b.x);
        };
        const auto [p, q] = std::minmax_element(points.begin(), points.begin() + found, before);
        add_segment(row, *p, *q);
    }

    void add_segment(int row, LinePoint p, LinePoint q) {
        const CellRange k = columns_.meeting(p.along - kCrossingError, q.along + kCrossingError);
        const double slope = q.along > p.along ? (q.x - p.x) / (q.along - p.along) : 0;
        const auto [x_min, x_max] = std::minmax(p.x, q.x);
        for (int column = k.first; column <= k.last; ++column) {
            const double low = columns_.low(column);
            const double high = columns_.high(column);
            const double from = low <= p.along ? p.x : p.x + (low - p.along) * slope;
            const double to = high >= q.along ? q.x : p.x + (high - p.along) * slope;
            include(row, {column, column}, std::clamp(from, x_min, x_max));
            include(row, {column, column}, std::clamp(to, x_min, x_max));
        }
    }

    /// Edges that cross a cell's side at z = c.
    void add_crossings_of_z(const std::array<Vec3d, 3>& corners, int column, double c) {
        for (int i = 0; i < 3; ++i) {
            const Vec3d& a = corners[static_cast<std::size_t>(i)];
            const Vec3d& b = corners[static_cast<std::size_t>((i + 1) % 3)];
            if (a.z == b.z || std::min(a.z, b.z) > c || std::max(a.z, b.z) < c) continue;
            const double t = (c - a.z) / (b.z - a.z);
            const double y = a.y + t * (b.y - a.y);
            const CellRange j = rows_.meeting(y - kCrossingError, y + kCrossingError);
            for (int row = j.first; row <= j.last; ++row)
                include(row, {column, column}, a.x + t * (b.x - a.x));
        }
    }

    GrownCells rows_;
    GrownCells columns_;
    DepthMap depths_;
};

/// The one cell that holds a vertex, or `several` (none counts as several): triangles whose vertices share
/// one cell lie inside it, and then the vertices alone decide.
struct VertexCell {
    static constexpr int kSeveral = -1;
    int row = kSeveral;
    int column = kSeveral;
};

}  // namespace

Reach reach(double clearance_mm, bool cut_on_touch) {
    return {(cut_on_touch ? clearance_mm : clearance_mm - kFaceTolerance) + kRounding};
}

DepthMap depth_map(const Mesh& mesh, const Placement& placement, const DesignSpace& space, Reach reach) {
    DepthMapBuilder builder(space, reach);
    std::vector<Vec3d> placed(mesh.vertices.size());
    std::vector<VertexCell> cells(mesh.vertices.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Vec3d p = placed[i] = placement(mesh.vertices[i]);
        const CellRange j = builder.rows().holding(p.y);
        const CellRange k = builder.columns().holding(p.z);
        builder.add_vertex(p, j, k);
        if (j.first == j.last && k.first == k.last) cells[i] = {j.first, k.first};
    }
    for (const Triangle& triangle : mesh.triangles) {
        const VertexCell a = cells[triangle[0]], b = cells[triangle[1]], c = cells[triangle[2]];
        const bool one_cell = a.row != VertexCell::kSeveral && a.row == b.row && a.row == c.row &&
                              a.column == b.column && a.column == c.column;
        if (!one_cell) builder.add_triangle({placed[triangle[0]], placed[triangle[1]], placed[triangle[2]]});
    }
    return builder.take();
}

}  // namespace snug
