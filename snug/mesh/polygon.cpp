#include <cmath>

#include "snug/mesh/raw_mesh.h"

namespace snug {
namespace {

constexpr std::size_t kMostCornersToClip = 64;  // ear clipping takes the cube of this at worst

struct Point {
    double u, v;
};

double turn(Point a, Point b, Point c) {
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/// The corners seen along the polygon's area vector, so that it runs counter-clockwise: the coordinate along
/// which the area is largest is dropped.
std::vector<Point> flattened(const RawMesh& mesh, std::span<const std::uint32_t> corners) {
    const Vec3d base = mesh.vertices[corners[0]];
    Vec3d area;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area = area + cross(mesh.vertices[corners[i]] - base, mesh.vertices[corners[i + 1]] - base);
    int axis = 0;
    for (int other = 1; other < 3; ++other)
        if (std::fabs(area[other]) > std::fabs(area[axis])) axis = other;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool mirrored = area[axis] < 0;
    std::vector<Point> points;
    points.reserve(corners.size());
    for (const std::uint32_t corner : corners) {
        const Vec3d p = mesh.vertices[corner] - base;
        points.push_back(mirrored ? Point{p[v], p[u]} : Point{p[u], p[v]});
    }
    return points;
}

bool convex(const std::vector<Point>& points) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0) return false;
    return true;
}

bool inside(Point a, Point b, Point c, Point p) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// The place in `ring` of a corner that can be cut off, or ring.size() if there is none.
std::size_t find_ear(const std::vector<Point>& points, const std::vector<std::size_t>& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = ring[(i + n - 1) % n], at = ring[i], after = ring[(i + 1) % n];
        if (!(turn(points[before], points[at], points[after]) > 0)) continue;
        bool free = true;
        for (const std::size_t other : ring)
            free = free && (other == before || other == at || other == after ||
                            !inside(points[before], points[at], points[after], points[other]));
        if (free) return i;
    }
    return n;
}

/// Fails, leaving the mesh as it was, on polygons that cross themselves.
bool clip_ears(RawMesh& mesh, std::span<const std::uint32_t> corners, const std::vector<Point>& points) {
    std::vector<std::size_t> ring(corners.size());
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
    const std::size_t first = mesh.triangles.size();
    while (ring.size() > 3) {
        const std::size_t n = ring.size(), ear = find_ear(points, ring);
        if (ear == n) {
            mesh.triangles.resize(first);
            return false;
        }
        mesh.triangles.push_back(
            {corners[ring[(ear + n - 1) % n]], corners[ring[ear]], corners[ring[(ear + 1) % n]]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    mesh.triangles.push_back({corners[ring[0]], corners[ring[1]], corners[ring[2]]});
    return true;
}

}  // namespace

void append_polygon(RawMesh& mesh, std::span<const std::uint32_t> corners) {
    if (corners.size() > 3 && corners.size() <= kMostCornersToClip) {
        const std::vector<Point> points = flattened(mesh, corners);
        if (!convex(points) && clip_ears(mesh, corners, points)) return;
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace snug
