#include "tests/support/random_design.h"

#include <algorithm>

namespace snug::test {
namespace {

Vec3d random_block(Random& random) {
    static constexpr double kSizes[] = {1, 2.5, 8, 9.6, 10, 12.7, 15, 22, 25.4};
    const auto one = [&] { return kSizes[random.integer(0, 8)]; };
    return {one(), one(), one()};
}

/// A point on block faces and edges of the space, sometimes half-way between.
Vec3d snapped_point(Random& random, const DesignSpace& space) {
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis) {
        const int face = random.integer(0, space.blocks[axis]);
        p[axis] = space.face(axis, face);
        if (random.chance(0.15) && face < space.blocks[axis]) p[axis] += space.block_mm[axis] / 2;
    }
    return p;
}

Vec3d point_near(Random& random, const DesignSpace& space, Vec3d centre, double share) {
    const Vec3d half = space.size() * 0.5;
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = std::clamp(centre[axis] + random.between(-share, share) * half[axis], -half[axis] * 0.999,
                             half[axis] * 0.999);
    return p;
}

void add_triangle(RandomDesign& design, Random& random) {
    const Vec3d centre = point_near(random, design.space, {}, 1);
    const double share = random.chance(0.5) ? 0.15 : 0.8;
    const auto first = static_cast<std::uint32_t>(design.mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
        const bool reuse = first > 0 && random.chance(0.3);
        const Vec3d p = design.snapped ? snapped_point(random, design.space)
                                       : point_near(random, design.space, centre, share);
        design.mesh.vertices.push_back(
            reuse ? design.mesh
                        .vertices[static_cast<std::size_t>(random.integer(0, static_cast<int>(first) - 1))]
                  : vec_cast<float>(p));
    }
    design.mesh.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

RandomDesign random_design(Random& random) {
    RandomDesign design;
    design.space.blocks = {random.integer(1, 14), random.integer(1, 12), random.integer(1, 12)};
    design.space.block_mm = random_block(random);
    design.snapped = random.chance(0.5);
    const int triangles = random.chance(0.3) ? random.integer(1, 3) : random.integer(4, 40);
    for (int t = 0; t < triangles; ++t) add_triangle(design, random);

    // Snapped corners must stay on the faces: only the identity keeps them there in any space. The others are
    // turned freely; what leaves the space is not cut, and must not disturb what is.
    if (!design.snapped) {
        const Vec3d angles =
            random.chance(0.3)
                ? Vec3d{90.0 * random.integer(-4, 4), 90.0 * random.integer(-4, 4),
                        90.0 * random.integer(-4, 4)}
                : Vec3d{random.between(-360, 360), random.between(-360, 360), random.between(-360, 360)};
        const Vec3d offset = random.chance(0.5) ? Vec3d{} : point_near(random, design.space, {}, 0.3);
        design.placement = place(design.mesh, angles, offset);
    }
    const Vec3d block = design.space.block_mm;
    const double smallest = std::min({block.x, block.y, block.z});
    switch (random.integer(0, 3)) {
        case 0:
            break;
        case 1:
            design.clearance = random.between(-0.4, 0) * smallest;
            break;
        case 2:
            design.clearance = random.between(0, 2) * smallest;
            break;
        default:
            design.clearance = 0.25 * random.integer(-1, 4) * smallest;
            break;
    }
    design.cut_on_touch = random.chance(0.4);
    return design;
}

std::vector<PlacedTriangle> placed_triangles(const Mesh& mesh, const Placement& placement) {
    std::vector<PlacedTriangle> triangles;
    for (const Triangle& t : mesh.triangles)
        triangles.push_back(
            {placement(mesh.vertices[t[0]]), placement(mesh.vertices[t[1]]), placement(mesh.vertices[t[2]])});
    return triangles;
}

}  // namespace snug::test
