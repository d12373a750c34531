#include "tests/support/sampled_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace snug::test {
namespace {

/// Points so that no place of the surface is further than spacing / sqrt(3) from one: the corners of
/// triangles whose sides are all at most `spacing`.
void sample_triangle(Vec3d a, Vec3d b, Vec3d c, double spacing, std::vector<Vec3d>& points) {
    const auto squared = [](Vec3d v) { return dot(v, v); };
    const double ab = squared(b - a), bc = squared(c - b), ca = squared(a - c);
    const double longest = std::max({ab, bc, ca});
    if (longest <= spacing * spacing) {
        points.insert(points.end(), {a, b, c});
        return;
    }
    if (longest > ab && longest == bc) return sample_triangle(b, c, a, spacing, points);
    if (longest > ab) return sample_triangle(c, a, b, spacing, points);
    const Vec3d middle = (a + b) * 0.5;
    sample_triangle(a, middle, c, spacing, points);
    sample_triangle(middle, b, c, spacing, points);
}

/// Without the points that lie within `distance` of one that is kept.
std::vector<Vec3d> thinned(const std::vector<Vec3d>& points, double distance) {
    constexpr std::int64_t kRow = 1 << 20;
    std::unordered_map<std::int64_t, std::vector<Vec3d>> kept_in;  // cells of that size
    const auto has_kept = [&](std::int64_t cell, Vec3d p) {
        const auto found = kept_in.find(cell);
        return found != kept_in.end() &&
               std::any_of(found->second.begin(), found->second.end(),
                           [&](Vec3d q) { return dot(q - p, q - p) <= distance * distance; });
    };
    std::vector<Vec3d> kept;
    for (const Vec3d& p : points) {
        const auto along = [&](double x) { return static_cast<std::int64_t>(std::floor(x / distance)); };
        const std::int64_t own = (along(p.x) * kRow + along(p.y)) * kRow + along(p.z);
        bool near = has_kept(own, p);
        for (std::int64_t i = -1; !near && i <= 1; ++i)
            for (std::int64_t j = -1; !near && j <= 1; ++j)
                for (std::int64_t k = -1; !near && k <= 1; ++k)
                    near = has_kept(own + (i * kRow + j) * kRow + k, p);
        if (near) continue;
        kept_in[own].push_back(p);
        kept.push_back(p);
    }
    return kept;
}

}  // namespace

Vec3d random_direction(Random& random) {
    return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

Mesh sampled(const Mesh& mesh, double spacing, double noise) {
    // Half of the distance goes to the samples, half to the thinning, which makes a fine mesh as sparse as a
    // coarse one.
    std::vector<Vec3d> points;
    for (const auto& [a, b, c] : mesh.triangles)
        sample_triangle(vec_cast<double>(mesh.vertices[a]), vec_cast<double>(mesh.vertices[b]),
                        vec_cast<double>(mesh.vertices[c]), spacing / 2, points);
    points = thinned(points, spacing / 2 / std::sqrt(3.0));
    Random random(static_cast<std::uint64_t>(spacing * 100));
    Mesh cloud;
    for (const Vec3d& p : points)
        cloud.vertices.push_back(vec_cast<float>(p + random_direction(random) * (noise / std::sqrt(3.0))));
    return cloud;
}

Mesh without_end(const Mesh& cloud, int axis, double share, bool low) {
    const Box3d box = bounds(cloud);
    const double length = share * box.size()[axis];
    Mesh rest;
    for (const Vec3f& p : cloud.vertices) {
        const double at = static_cast<double>(p[axis]);
        if (low ? at >= box.min[axis] + length : at <= box.max[axis] - length) rest.vertices.push_back(p);
    }
    return rest;
}

}  // namespace snug::test
