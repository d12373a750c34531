#include "snug/mesh/shell.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "snug/depth/depth_map.h"
#include "snug/mesh/measure.h"
#include "snug/samples/samples.h"

#include "tests/support/random_design.h"

// The closed surface around the cubes that an object meets.

namespace snug {
namespace {

using test::Random;

Mesh shell_of(const Mesh& mesh, int most, double& side) {
    MetCubes cubes(bounds(mesh), most);
    for (const Triangle& t : mesh.triangles)
        cubes.mark({vec_cast<double>(mesh.vertices[t[0]]), vec_cast<double>(mesh.vertices[t[1]]),
                    vec_cast<double>(mesh.vertices[t[2]])});
    side = cubes.side();
    return cubes.shell();
}

/// Every column sees the shell where it sees the object, on both sides of it, and not much farther out.
void expect_held(const Mesh& mesh, const Mesh& shell, double side, Vec3d turn) {
    const Placement placement = place(mesh, turn, {});
    const DesignSpace space{{64, 64, 64}, {8, 8, 8}};
    const Reach here = reach(0, true), around = reach(5.3 * side, true);
    const DepthMap object = depth_map(mesh, placement, space, here);
    const DepthMap near = depth_map(mesh, placement, space, around);
    const DepthMap held = depth_map(shell, placement, space, here);
    for (std::size_t column = 0; column < object.size(); ++column) {
        if (!object[column].none()) {
            ASSERT_FALSE(held[column].none());
            EXPECT_LE(held[column].lowest, object[column].lowest + 1e-4);
            EXPECT_GE(held[column].highest, object[column].highest - 1e-4);
        }
        if (held[column].none()) continue;
        ASSERT_FALSE(near[column].none());
        EXPECT_GE(held[column].lowest, near[column].lowest - 5.3 * side);
        EXPECT_LE(held[column].highest, near[column].highest + 5.3 * side);
    }
}

TEST(Shell, HoldsTheSamplesAndIsClosed) {
    for (const std::string_view name : sample_names())
        for (const int most : {24, 192}) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(most));
            const Mesh mesh = *sample(name);
            double side = 0;
            const Mesh shell = shell_of(mesh, most, side);
            EXPECT_TRUE(measure(shell).watertight);
            EXPECT_GT(measure(shell).volume.value_or(0), 0);
            expect_held(mesh, shell, side, {20, 30, 40});
        }
}

TEST(Shell, HoldsRandomSoups) {
    for (int seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = test::random_design(random).mesh;
        double side = 0;
        const Mesh shell = shell_of(mesh, random.integer(1, 60), side);
        EXPECT_TRUE(measure(shell).watertight);
        expect_held(mesh, shell, side, {random.between(0, 360), 0, random.between(0, 360)});
    }
}

TEST(Shell, IsTheSameInWhicheverOrderTrianglesAreMarked) {
    const Mesh mesh = *sample("figurine");
    Mesh turned = mesh;
    std::reverse(turned.triangles.begin(), turned.triangles.end());
    double side = 0;
    const Mesh a = shell_of(mesh, 64, side), b = shell_of(turned, 64, side);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace snug
