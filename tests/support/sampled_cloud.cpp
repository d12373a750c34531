#include "tests/support/sampled_cloud.h"

#include <algorithm>
#include <cmath>
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

}  // namespace

Vec3d random_direction(Random& random) {
    return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

Mesh sampled(const Mesh& mesh, double spacing, double noise) {
    std::vector<Vec3d> points;
    for (const auto& [a, b, c] : mesh.triangles)
        sample_triangle(vec_cast<double>(mesh.vertices[a]), vec_cast<double>(mesh.vertices[b]),
                        vec_cast<double>(mesh.vertices[c]), spacing, points);
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
