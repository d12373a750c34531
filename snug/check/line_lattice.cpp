#include "snug/check/line_lattice.h"

#include <algorithm>

namespace snug {
namespace {

/// Keeps every product of two differences below 2^61. The largest design space has 2^28 units a side.
constexpr double kFarthest = 1 << 29;

std::int32_t snapped(double units) {
    const double clamped = std::clamp(units, -kFarthest, kFarthest);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(clamped + kFarthest + 0.5) -
                                     static_cast<std::int64_t>(kFarthest));
}

/// Twice the area of the triangle from an edge to the point (u, v): positive to the left of it.
std::int64_t edge_function(const SnappedVertex& from, const SnappedVertex& to, std::int32_t u,
                           std::int32_t v) {
    return static_cast<std::int64_t>(to.u - from.u) * (v - from.v) -
           static_cast<std::int64_t>(to.v - from.v) * (u - from.u);
}

/// Whether points on the edge belong to the triangle on its left. Never true of both directions.
bool owns_its_points(const SnappedVertex& from, const SnappedVertex& to) {
    return to.v > from.v || (to.v == from.v && to.u > from.u);
}

bool is_left(std::int64_t value, const SnappedVertex& from, const SnappedVertex& to) {
    return value > 0 || (value == 0 && owns_its_points(from, to));
}

}  // namespace

LineLattice::Axis LineLattice::axis(int columns, int bits) {
    const std::int32_t units = columns << kColumnBits, cell = 1 << bits;
    const int cells = (units - 1) / cell + 1;
    return {cells, units - (cells - 1) * cell};
}

LineLattice::LineLattice(const DesignSpace& space, int cell_bits)
    : bits_(cell_bits),
      along_y_(axis(space.blocks.y, cell_bits)),
      along_z_(axis(space.blocks.z, cell_bits)),
      y_begin_(space.face(1, 0)),
      z_begin_(space.face(2, 0)),
      units_per_mm_y_(kUnitsPerCell * kPerColumn / space.block_mm.y),
      units_per_mm_z_(kUnitsPerCell * kPerColumn / space.block_mm.z) {}

double LineLattice::lines_per_column() const {
    const double along = static_cast<double>(lines_along_column()) / columns_along_cell();
    return along * along;
}

double LineLattice::share(int row, int column) const {
    const double cell = 1 << bits_;
    return along_y_.extent(bits_, row) / cell * (along_z_.extent(bits_, column) / cell);
}

SnappedVertex LineLattice::snap(Vec3d p) const {
    return {snapped((p.y - y_begin_) * units_per_mm_y_), snapped((p.z - z_begin_) * units_per_mm_z_), p.x};
}

std::vector<SnappedVertex> snapped(const LineLattice& lattice, std::span<const Vec3d> points) {
    std::vector<SnappedVertex> all;
    all.reserve(points.size());
    for (const Vec3d& point : points) all.push_back(lattice.snap(point));
    return all;
}

std::int64_t doubled_shadow(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) {
    return edge_function(a, b, c.u, c.v);
}

std::optional<Crossing> crossing(std::int32_t u, std::int32_t v, const SnappedVertex& a,
                                 const SnappedVertex& b, const SnappedVertex& c) {
    const std::int64_t area = doubled_shadow(a, b, c);
    if (area < 0) {
        std::optional<Crossing> mirrored = crossing(u, v, a, c, b);
        if (mirrored) mirrored->turn = 1;
        return mirrored;
    }
    if (area == 0) return std::nullopt;
    const std::int64_t to_c = edge_function(a, b, u, v);
    if (!is_left(to_c, a, b)) return std::nullopt;
    const std::int64_t to_a = edge_function(b, c, u, v);
    if (!is_left(to_a, b, c)) return std::nullopt;
    const std::int64_t to_b = edge_function(c, a, u, v);
    if (!is_left(to_b, c, a)) return std::nullopt;
    const double x = (static_cast<double>(to_a) * a.x + static_cast<double>(to_b) * b.x +
                      static_cast<double>(to_c) * c.x) /
                     static_cast<double>(area);
    return Crossing{x, -1};
}

}  // namespace snug
