#include "snug/check/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "snug/samples/samples.h"

#include "tests/support/random.h"

namespace snug {
namespace {

/// Over every triangle, in design coordinates.
double nearest_of_all(const Mesh& mesh, const Placement& placement, Vec3d place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : mesh.triangles) {
        const Vec3d point =
            nearest_on_triangle(placement(mesh.vertices[t[0]]), placement(mesh.vertices[t[1]]),
                                placement(mesh.vertices[t[2]]), place);
        nearest = std::min(nearest, std::sqrt(dot(point - place, point - place)));
    }
    return nearest;
}

TEST(SurfaceDistance, IsTheBruteForcesForEveryPlacement) {
    const auto mesh = sample("torus");
    ASSERT_TRUE(mesh);
    const auto surface = SurfaceDistance::build(*mesh);
    ASSERT_TRUE(surface);
    const std::uint64_t seed = 42;
    SCOPED_TRACE(seed);
    test::Random random(seed);
    for (int i = 0; i < 40; ++i) {
        const Vec3d rotation{random.between(-180, 180), random.between(-180, 180), random.between(-180, 180)};
        const Placement placement = place(*mesh, rotation, {random.between(-50, 50), 3, -7});
        const Vec3d at{random.between(-200, 200), random.between(-200, 200), random.between(-200, 200)};
        EXPECT_NEAR(surface->at(at, placement), nearest_of_all(*mesh, placement, at), 1e-9);
    }
}

TEST(SurfaceDistance, IsZeroOnTheSurface) {
    const auto mesh = sample("camera");
    ASSERT_TRUE(mesh);
    const auto surface = SurfaceDistance::build(*mesh);
    ASSERT_TRUE(surface);
    const Placement placement = place(*mesh, {30, 40, 50}, {});
    for (std::size_t i = 0; i < mesh->vertices.size(); i += 97)
        EXPECT_NEAR(surface->at(placement(mesh->vertices[i]), placement), 0, 1e-9);
}

}  // namespace
}  // namespace snug
