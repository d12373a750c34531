#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "snug/base/vec.h"
#include "snug/depth/cells.h"
#include "snug/depth/depth_map.h"
#include "snug/depth/depth_tiles.h"
#include "snug/space/design_space.h"

namespace snug {

/// A computed crossing may be rounded to just outside the cell whose side it was computed on, and an edge
/// through a cell's corner must not be lost on both sides that meet there (mm). Well below what a reach adds
/// against rounding, well above a double's error.
inline constexpr double kCrossingError = 1e-10;

/// The one cell that holds a vertex, or `several` (none counts as several): triangles whose vertices share
/// one cell lie inside it, and then the vertices alone decide.
struct VertexCell {
    static constexpr int kSeveral = GrownCells::kNotOne;
    int row = kSeveral;
    int column = kSeveral;
    friend bool operator==(VertexCell, VertexCell) = default;

    [[nodiscard]] bool one() const { return row != kSeveral && column != kSeveral; }
};

[[nodiscard]] constexpr std::size_t next_corner(std::size_t corner) {
    return corner == 2 ? 0 : corner + 1;
}

/// The edges of a triangle that meet a line of constant y or z, in their order; edge i runs from corner i to
/// the next. `at`: the corners' y or z.
struct CrossedEdges {
    std::uint8_t count = 0;
    std::array<std::uint8_t, 3> edge{};
};
/// By which corners lie beyond the line (bits 0 to 2), where none lies on it: the two edges of the one that
/// lies alone.
inline constexpr std::array<CrossedEdges, 8> kEdgesOfLoneCorner = {
    {{0, {}}, {2, {0, 2}}, {2, {0, 1}}, {2, {1, 2}}, {2, {1, 2}}, {2, {0, 1}}, {2, {0, 2}}, {0, {}}}};

[[nodiscard]] inline CrossedEdges crossed_edges(const std::array<double, 3>& at, double line) {
    const auto [a, b, c] = at;
    if ((a != line) & (b != line) & (c != line))
        return kEdgesOfLoneCorner[static_cast<std::size_t>((a > line) | (b > line) << 1 | (c > line) << 2)];
    // A corner on the line belongs to both of its edges, and an edge along the line is none.
    CrossedEdges crossed;
    for (std::size_t i = 0; i < 3; ++i) {
        const double from = at[i], to = at[next_corner(i)];
        if (from != to && std::min(from, to) <= line && std::max(from, to) >= line)
            crossed.edge[crossed.count++] = static_cast<std::uint8_t>(i);
    }
    return crossed;
}

/// The columns where both indices lie within a range.
struct ColumnBlock {
    CellRange j, k;
    [[nodiscard]] bool large() const { return DepthTiles::pay(j.last - j.first + 1, k.last - k.first + 1); }
};

/// Fills a depth map with placed vertices and triangles: the exact rule, in one place for every way of
/// choosing which of them are looked at.
///
/// The surface inside one grown cell is a set of polygons: triangles clipped to the cell. The extremes of x
/// over such a polygon lie at its corners, and those are of three kinds: the triangle's own vertices, points
/// where its edges cross the cell's sides, and points above the cell's corners. Each kind is found without
/// clipping: vertices one by one, and the other two on the lines that bound the cells.
class DepthMapBuilder {
  public:
    DepthMapBuilder(const DesignSpace& space, Reach reach);
    /// Begins with what is known already.
    DepthMapBuilder(const DesignSpace& space, Reach reach, DepthMap known);

    /// Counts a vertex in the cells that hold it, and says which.
    VertexCell add_vertex(Vec3d p) {
        const VertexCell cell{rows_.sole(p.y), columns_.sole(p.z)};
        if (!cell.one()) return add_vertex_of_several(p);
        depths_(cell.row, cell.column).include(p.x);
        return cell;
    }

    /// The same, but only cells of the block are looked at: it must hold all that hold the vertex.
    void add_vertex(Vec3d p, const ColumnBlock& block);

    /// The edges of a triangle whose vertices do not share one cell.
    void add_triangle(const std::array<Vec3d, 3>& corners);
    /// The same, unless it is large: then false, and nothing is done.
    [[nodiscard]] bool add_small_triangle(const std::array<Vec3d, 3>& corners);
    /// The same, but only cells of the block are looked at, and of those only the ones that x from `x_min` to
    /// `x_max` would change: the block must hold all cells that the triangle meets, and the range all x that
    /// it reaches, with kCrossingError and rounding.
    void add_triangle(const std::array<Vec3d, 3>& corners, const ColumnBlock& block, double x_min,
                      double x_max);

    /// The columns that a triangle may meet, with what rounding may add.
    [[nodiscard]] ColumnBlock met_by(const std::array<Vec3d, 3>& corners) const;
    /// The edges of a triangle as far as columns of the block see them: the block need not hold all that the
    /// triangle meets.
    void add_edges_within(const std::array<Vec3d, 3>& corners, const ColumnBlock& block);

    /// What another has found, for the same space and reach.
    void include(const DepthMapBuilder& other) {
        for (std::size_t column = 0; column < depths_.size(); ++column)
            depths_[column].include(other.depths_[column]);
    }

    [[nodiscard]] const GrownCells& rows() const { return rows_; }
    [[nodiscard]] const GrownCells& columns() const { return columns_; }
    [[nodiscard]] DepthMap& depths() { return depths_; }
    [[nodiscard]] const DepthMap& depths() const { return depths_; }
    [[nodiscard]] DepthMap take() { return std::move(depths_); }

  private:
    /// A point of a triangle on a line of constant y or z: where it is along the line, and its x.
    struct LinePoint {
        double along;
        double x;
    };
    struct Segment {
        LinePoint first, last;  ///< first.along <= last.along
    };

    [[nodiscard]] ColumnBlock block_of(const std::array<Vec3d, 3>& corners) const;
    VertexCell add_vertex_of_several(Vec3d p);
    void add_in_tiles(const std::array<Vec3d, 3>& corners, const ColumnBlock& block);
    void add_in_tile(const std::array<Vec3d, 3>& corners, const SpreadTriangle& triangle,
                     const ColumnBlock& block);
    [[nodiscard]] bool changes_any(const ColumnBlock& block, double x_min, double x_max) const;
    [[nodiscard]] SpreadTriangle::Rectangle over(const ColumnBlock& block) const;
    void add_in_block(const std::array<Vec3d, 3>& corners, const ColumnBlock& block, double x_min,
                      double x_max);
    [[nodiscard]] bool changes(int row, int column, double x_min, double x_max) const;
    /// The columns without those at both ends that x from `x_min` to `x_max` would not change.
    [[nodiscard]] CellRange changed_in_row(int row, CellRange columns, double x_min, double x_max) const;
    [[nodiscard]] static bool section_along_z(const std::array<Vec3d, 3>& corners, double c,
                                              Segment& segment);
    void add_segment(int row, const Segment& segment, CellRange columns);
    void add_crossings_of_z(const std::array<Vec3d, 3>& corners, int column, double c, CellRange rows);
    void add_crossing(double x, double y, int column, CellRange rows);

    GrownCells rows_;
    GrownCells columns_;
    DepthMap depths_;
    DepthTiles tiles_;  ///< made for the first large triangle
};

}  // namespace snug
