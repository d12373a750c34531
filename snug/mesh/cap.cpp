#include "snug/mesh/cap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace snug {
namespace {

using Loop = std::vector<std::uint32_t>;
using Points = std::vector<Vec3d>;

// In shares of a loop's size, the square root of the area that it encloses.
constexpr double kFlatHeight = 1e-6;  // a height that rounding to float alone makes
constexpr double kNearlyFlat = 0.5;  // the largest extent along its normal of a loop that a base may have had
constexpr double kNear = 0.1;        // how far beyond the loop the object's end may lie to be the base's, too

constexpr double kNoArea = 1e-6;     // of a loop's longest side squared: the normal is noise
constexpr double kSmallLoop = 0.01;  // of the object's diagonal: its base is not looked for

Points points_of(const Mesh& mesh, const Loop& loop) {
    Points points;
    for (const std::uint32_t v : loop) points.push_back(vec_cast<double>(mesh.vertices[v]));
    return points;
}

Vec3d centroid(const Points& points) {
    Vec3d sum;
    for (const Vec3d& p : points) sum = sum + p;
    return sum * (1.0 / static_cast<double>(points.size()));
}

/// Newell's: its length is the area that the loop encloses, seen along it.
Vec3d area_vector(const Points& points, Vec3d middle) {
    Vec3d sum;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum = sum + cross(points[i] - middle, points[(i + 1) % points.size()] - middle);
    return sum * 0.5;
}

std::uint32_t add_vertex(Mesh& mesh, Vec3d p) {
    mesh.vertices.push_back(vec_cast<float>(p));
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// A fan over the loop from its centroid. A loop runs as the triangles outside it do, so the fan runs against
/// it.
void add_fan(Mesh& mesh, const Loop& loop, Vec3d middle) {
    if (loop.size() < 3) return;
    if (loop.size() == 3) {
        mesh.triangles.push_back({loop[2], loop[1], loop[0]});
        return;
    }
    const std::uint32_t tip = add_vertex(mesh, middle);
    for (std::size_t i = 0; i < loop.size(); ++i)
        mesh.triangles.push_back({tip, loop[(i + 1) % loop.size()], loop[i]});
}

/// Heights along a normal above a loop's centroid.
struct Heights {
    double low = 0, high = 0;
    [[nodiscard]] double extent() const { return high - low; }
};

/// How a loop lies in space.
struct LoopShape {
    Points points;
    Vec3d middle;
    Vec3d normal;     ///< of length 1; none (zero) where the loop encloses no area
    double size = 0;  ///< square root of the area that the loop encloses
    Heights heights;  ///< of its points
};

LoopShape shape_of(const Mesh& mesh, const Loop& loop) {
    LoopShape shape;
    shape.points = points_of(mesh, loop);
    shape.middle = centroid(shape.points);
    Box3d box;
    for (const Vec3d& p : shape.points) box.include(p);
    const Vec3d area = area_vector(shape.points, shape.middle);
    const double longest = box.longest_side();
    if (length(area) <= kNoArea * longest * longest) return shape;
    shape.normal = area * (1 / length(area));
    shape.size = std::sqrt(length(area));
    for (const Vec3d& p : shape.points) {
        const double height = dot(shape.normal, p - shape.middle);
        shape.heights = {std::min(shape.heights.low, height), std::max(shape.heights.high, height)};
    }
    return shape;
}

/// The loop's heights, drawn out to the ends of the object that lie near.
Heights heights_of_base(const Mesh& mesh, const LoopShape& loop, double diagonal) {
    Heights base = loop.heights;
    if (loop.size < kSmallLoop * diagonal) return base;
    const double lowest = loop.heights.low - kNear * loop.size,
                 highest = loop.heights.high + kNear * loop.size;
    bool low_end = true, high_end = true;
    for (std::size_t v = 0; v < mesh.vertices.size() && (low_end || high_end); ++v) {
        const double height = dot(loop.normal, vec_cast<double>(mesh.vertices[v]) - loop.middle);
        low_end = low_end && height >= lowest;
        high_end = high_end && height <= highest;
        base = {std::min(base.low, height), std::max(base.high, height)};
    }
    return {low_end ? base.low : loop.heights.low, high_end ? base.high : loop.heights.high};
}

/// The loop pressed flat onto the plane at a height.
Loop add_projection(Mesh& mesh, const LoopShape& loop, double height) {
    Loop projection;
    for (const Vec3d& p : loop.points) {
        const double own = dot(loop.normal, p - loop.middle);
        projection.push_back(add_vertex(mesh, p + loop.normal * (height - own)));
    }
    return projection;
}

/// A closed prism over the loop's outline: fans at both heights and a wall between them, outward.
void add_prism(Mesh& mesh, const LoopShape& loop, Heights heights) {
    Loop low = add_projection(mesh, loop, heights.low);
    const Loop high = add_projection(mesh, loop, heights.high);
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t next = (i + 1) % low.size();
        mesh.triangles.push_back({low[i], low[next], high[next]});
        mesh.triangles.push_back({low[i], high[next], high[i]});
    }
    add_fan(mesh, low, loop.middle + loop.normal * heights.low);
    add_fan(mesh, Loop(high.rbegin(), high.rend()), loop.middle + loop.normal * heights.high);
}

}  // namespace

Mesh span_of_loops(const Mesh& mesh, const std::vector<Loop>& loops) {
    Mesh span;
    span.origin = mesh.origin;
    for (const Loop& loop : loops) {
        const Points points = points_of(mesh, loop);
        Loop own;
        for (const Vec3d& p : points) own.push_back(add_vertex(span, p));
        add_fan(span, own, centroid(points));
    }
    return span;
}

Mesh capped(const Mesh& mesh, const std::vector<Loop>& loops) {
    Mesh result = mesh;
    const Vec3d object_size = bounds(mesh).size();
    for (const Loop& loop : loops) {
        const LoopShape shape = shape_of(mesh, loop);
        add_fan(result, loop, shape.middle);
        if (shape.size <= 0 || shape.heights.extent() > kNearlyFlat * shape.size) continue;
        const Heights base = heights_of_base(mesh, shape, length(object_size));
        if (base.extent() > kFlatHeight * shape.size) add_prism(result, shape, base);
    }
    result.cap_vertices = result.vertices.size() - mesh.vertices.size();
    return result;
}

}  // namespace snug
