#include "snug/polygon/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "snug/mesh/raw_mesh.h"
#include "snug/polygon/ear_clipping.h"

namespace snug {
namespace {

constexpr std::size_t kMostCornersToClip = 1000;  // the time goes with the square of this
constexpr double kFlat = 1e-12;                   // of the polygon's area: a corner that rounding left over

/// The corners seen along the polygon's area vector, so that it runs counter-clockwise: the coordinate along
/// which the area is largest is dropped, which keeps what is inside what. Gives twice the area seen so.
template <class T>
double flatten(const RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners, std::span<Vec2d> points) {
    const auto place = [&](std::size_t i) { return vec_cast<double>(mesh.vertices[corners[i]]); };
    const Vec3d base = place(0);
    Vec3d area;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area = area + cross(place(i) - base, place(i + 1) - base);
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::fabs(area[other]) > std::fabs(area[axis])) axis = other;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool mirrored = area[axis] < 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d p = place(i) - base;
        points[i] = mirrored ? Vec2d{p[v], p[u]} : Vec2d{p[u], p[v]};
    }
    return std::fabs(area[axis]);
}

/// Triangles that all run the polygon's way round and have its outline together cover its inside once and
/// nothing else: each point is covered as often as the outline goes round it.
bool fan_stays_inside(std::span<const Vec2d> points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        if (orientation(points[0], points[i], points[i + 1]) < 0) return false;
    return true;
}

/// Fails, leaving the triangles as they were, on polygons that cross themselves.
bool clip_ears_of(std::vector<Triangle>& into, std::span<const std::uint32_t> corners,
                  std::span<const Vec2d> points, double area) {
    std::vector<std::array<std::size_t, 3>> triangles;
    if (!clip_ears(points, kFlat * area, triangles)) return false;
    for (const auto& [a, b, c] : triangles) into.push_back({corners[a], corners[b], corners[c]});
    return true;
}

template <class T>
bool clip_where_a_fan_would_leave(RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners) {
    std::array<Vec2d, 8> few;
    std::vector<Vec2d> many(corners.size() > few.size() ? corners.size() : 0);
    const std::span<Vec2d> points = many.empty() ? std::span<Vec2d>(few).first(corners.size()) : many;
    const double area = flatten(mesh, corners, points);
    return !fan_stays_inside(points) && clip_ears_of(mesh.triangles, corners, points, area);
}

}  // namespace

template <class T>
void append_polygon(RawMeshOf<T>& mesh, std::span<const std::uint32_t> corners) {
    const auto wrong = [&](std::uint32_t v) { return !usable(mesh.vertices[v]); };
    if (corners.size() < 3 || (corners.size() > 3 && std::any_of(corners.begin(), corners.end(), wrong))) {
        ++mesh.read.left_out_faces;
        return;
    }
    if (corners.size() > 3 && corners.size() <= kMostCornersToClip &&
        clip_where_a_fan_would_leave(mesh, corners))
        return;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

template void append_polygon(RawMeshOf<float>&, std::span<const std::uint32_t>);
template void append_polygon(RawMeshOf<double>&, std::span<const std::uint32_t>);

}  // namespace snug
