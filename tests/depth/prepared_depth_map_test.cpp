#include <algorithm>
#include <cstring>
#include <optional>
#include <tbb/global_control.h>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/parallel.h"
#include "snug/depth/depth_map.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/mesh/cap.h"
#include "snug/mesh/measure.h"
#include "snug/object/turned_bounds.h"
#include "snug/samples/samples.h"

#include "tests/support/cases.h"
#include "tests/support/models.h"
#include "tests/support/random_design.h"
#include "tests/support/small_meshes.h"

// A prepared surface against the plain pass over every vertex and triangle, which method_test.cpp checks
// against a brute force: the same numbers to the bit, however much was refused and on however many threads.

namespace snug {
namespace {

using test::Random;

/// Every column equal to the last bit, the sign of zero aside.
void expect_same(const DepthMap& prepared, const DepthMap& plain) {
    ASSERT_EQ(prepared.ny(), plain.ny());
    ASSERT_EQ(prepared.nz(), plain.nz());
    for (int j = 0; j < plain.ny(); ++j) {
        for (int k = 0; k < plain.nz(); ++k) {
            ASSERT_EQ(prepared(j, k).lowest, plain(j, k).lowest) << "column " << j << " " << k;
            ASSERT_EQ(prepared(j, k).highest, plain(j, k).highest) << "column " << j << " " << k;
        }
    }
}

void expect_same(const Placement& prepared, const Placement& plain) {
    EXPECT_EQ(prepared.shift, plain.shift);
    EXPECT_EQ(prepared.bounds, plain.bounds);
}

/// The space of n x n x n blocks in which the object fits however it is turned.
DesignSpace space_around(const Mesh& mesh, int n) {
    const Vec3d size = bounds(mesh).size();
    const double side = (size.x + size.y + size.z) * 0.8;
    return {{n, n, n}, {side / n, side / n, side / n}};
}

/// A finely cut surface with dents, folds and a tilt of its own, as a scan has, and small noise on it.
Mesh noisy_scan(Random& random, int triangles_along) {
    const Vec3d wave{random.between(0.5, 3), random.between(0.5, 3), random.between(5, 30)};
    Mesh mesh;
    const int n = triangles_along;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            const double u = 2.0 * i / n - 1, v = 2.0 * j / n - 1;
            const double height =
                wave.z * (u * u * wave.x - v * v * wave.y + u * v) + random.between(-0.3, 0.3);
            mesh.vertices.push_back(vec_cast<float>(Vec3d{height, 80 * u, 50 * v}));
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const auto a = static_cast<std::uint32_t>(i * (n + 1) + j);
            const auto below = static_cast<std::uint32_t>(a + static_cast<std::uint32_t>(n) + 1);
            mesh.triangles.push_back({a, a + 1, below});
            mesh.triangles.push_back({a + 1, below + 1, below});
        }
    }
    return mesh;
}

TEST(PreparedDepthMap, OfRandomSoupsIsThatOfThePlainPass) {
    int snapped = 0;
    for (int seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(static_cast<std::uint64_t>(seed));
        const test::RandomDesign design = test::random_design(random);
        const Reach grown = reach(design.clearance, design.cut_on_touch);
        expect_same(depth_map(prepare_surface(design.mesh), design.placement, design.space, grown),
                    depth_map(design.mesh, design.placement, design.space, grown));
        if (HasFatalFailure()) return;
        snapped += design.snapped;
    }
    EXPECT_GT(snapped, 1000);
}

TEST(PreparedDepthMap, OfScansIsThatOfThePlainPassAtAnyResolutionAndReach) {
    for (int seed = 0; seed < test::cases(12); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = noisy_scan(random, random.integer(20, 120));
        const PreparedSurface surface = prepare_surface(mesh);
        const Vec3d angles{random.between(0, 360), random.between(0, 360), random.between(0, 360)};
        const Vec3d offset{random.between(-30, 30), random.between(-30, 30), random.between(-30, 30)};
        const Placement placement = place(surface, angles, offset);
        expect_same(placement, place(mesh, angles, offset));
        for (const int n : {1, 2, 7, 30, 200}) {
            const DesignSpace space = space_around(mesh, n);
            const double block = space.block_mm.x;
            for (const double clearance : {0.0, -0.39 * block, 0.1 * block, 0.6 * block, 2.5 * block}) {
                SCOPED_TRACE(testing::Message() << n << " blocks, clearance " << clearance);
                const Reach grown = reach(clearance, random.chance(0.5));
                expect_same(depth_map(surface, placement, space, grown),
                            depth_map(mesh, placement, space, grown));
                if (HasFatalFailure()) return;
            }
        }
    }
}

TEST(PreparedDepthMap, OfSurfacesOnTheGridLinesIsThatOfThePlainPass) {
    // Vertices and edges on cell bounds, faces along them: touching counts the same.
    Mesh mesh;
    for (int i = 0; i <= 24; ++i)
        for (int j = 0; j <= 24; ++j)
            mesh.vertices.push_back({static_cast<float>((i * j) % 5), static_cast<float>(i - 12) * 2.5f,
                                     static_cast<float>(j - 12) * 2.5f});
    for (std::uint32_t i = 0; i < 24; ++i)
        for (std::uint32_t j = 0; j < 24; ++j) {
            const std::uint32_t a = i * 25 + j;
            mesh.triangles.push_back({a, a + 1, a + 25});
            mesh.triangles.push_back({a + 26, a + 25, a + 1});
        }
    const PreparedSurface surface = prepare_surface(mesh);
    const DesignSpace space{{14, 14, 14}, {5, 5, 5}};
    for (const double e : {0.0, 1e-9, -1e-9, -0.01, 0.01, 2.5, 5.0})
        for (const Vec3d angles : {Vec3d{}, Vec3d{90, 0, 0}, Vec3d{0, 90, 180}, Vec3d{30, 0, 0}}) {
            SCOPED_TRACE(testing::Message() << "reach " << e << ", turned " << angles.x << " " << angles.y);
            const Placement placement = place(mesh, angles, {});
            expect_same(depth_map(surface, placement, space, {e}), depth_map(mesh, placement, space, {e}));
        }
}

TEST(PreparedDepthMap, IsTheSameOnAnyNumberOfThreads) {
    Random random(5);
    const Mesh mesh = noisy_scan(random, 200);
    const PreparedSurface surface = prepare_surface(mesh);
    const DesignSpace space = space_around(mesh, 120);
    const Placement placement = place(surface, {20, 30, 40}, {});
    std::vector<DepthMap> maps;
    for (const std::size_t threads : {1u, 2u, 3u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        maps.push_back(depth_map(surface, placement, space, {-0.01}));
        maps.push_back(depth_map(mesh, placement, space, {-0.01}));
        const PreparedSurface again = prepare_surface(mesh);
        EXPECT_EQ(again.body.coordinates, surface.body.coordinates);
        EXPECT_EQ(again.body.corners, surface.body.corners);
    }
    for (const DepthMap& map : maps) expect_same(map, maps.front());
}

TEST(PreparedSurface, HoldsEveryTriangleOnceWithItsVertices) {
    for (int seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = seed % 2 ? noisy_scan(random, 30) : test::random_design(random).mesh;
        using Corners = std::array<std::array<float, 3>, 3>;
        std::vector<Corners> expected, found;
        for (const Triangle& t : mesh.triangles) {
            Corners corners;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3f v = mesh.vertices[t[i]];
                corners[i] = {v.x, v.y, v.z};
            }
            expected.push_back(corners);
        }
        const SurfaceClusters body = prepare_surface(mesh).body;
        for (const auto& cluster : body.clusters) {
            for (std::size_t t = 0; t < cluster.triangles; ++t) {
                Corners corners;
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::size_t v = body.corners[cluster.first_triangle + t][i];
                    ASSERT_LT(v, cluster.vertices);
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        corners[i][axis] =
                            body.coordinates[cluster.first_coordinate + axis * cluster.padded() + v];
                }
                found.push_back(corners);
            }
        }
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
    }
}

TEST(PreparedSurface, OfNothingIsNothing) {
    const PreparedSurface surface = prepare_surface(Mesh{});
    const DepthMap depths = depth_map(surface, Placement{}, DesignSpace{}, {0});
    for (const DepthRange& depth : depths) EXPECT_TRUE(depth.none());
    EXPECT_TRUE(turned_bounds(surface.body, Rotation{}).empty());
}

TEST(PreparedSurface, LiesWhereTheMeshLiesWithItsCaps) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(static_cast<std::uint64_t>(seed));
        Mesh mesh = noisy_scan(random, random.integer(2, 12));
        mesh = capped(mesh, measure(mesh).holes);
        ASSERT_GT(mesh.cap_vertices, 0u);
        const PreparedSurface surface = prepare_surface(mesh);
        EXPECT_FALSE(surface.caps.clusters.empty());
        const Vec3d angles = random.chance(0.3) ? Vec3d{90, 0, 180}
                                                : Vec3d{random.between(-360, 360), random.between(-360, 360),
                                                        random.between(-360, 360)};
        const Placement placement = place(surface, angles, {1, 2, 3});
        expect_same(placement, place(mesh, angles, {1, 2, 3}));
        const DesignSpace space = space_around(mesh, 20);
        expect_same(depth_map(surface, placement, space, {-0.01}),
                    depth_map(mesh, placement, space, {-0.01}));
    }
}

TEST(PreparedSurface, GivesTheSamePackingsOfRealObjects) {
    const auto bytes = test::model_file("stanford-bunny.obj");
    if (!bytes) GTEST_SKIP() << "the shared object stanford-bunny.obj is not here";
    Design design;
    design.object.longest_mm = 200;
    auto mesh = read_mesh(*bytes, "stanford-bunny.obj");
    ASSERT_TRUE(mesh.has_value());
    auto object = prepare(std::move(*mesh), design);
    ASSERT_TRUE(object.has_value());
    for (const Vec3d angles : {Vec3d{}, Vec3d{10, 20, 30}, Vec3d{90, 0, 45}}) {
        design.placement.rotation_deg = angles;
        object->prepared.reset();
        const auto once = pack(*object, design);
        prepare_for_many(*object);
        const auto again = pack(*object, design);
        ASSERT_TRUE(once && again && once->foams && again->foams);
        EXPECT_EQ(once->layers, again->layers);
        EXPECT_EQ(once->foams->parting, again->foams->parting);
        EXPECT_EQ(once->items.front().placement.bounds, again->items.front().placement.bounds);
    }
}

TEST(Parallel, EveryIndexIsWorkedOnceByAWorkerThatIsNotShared) {
    std::vector<int> calls(1000);
    std::vector<std::size_t> sums(worker_count());
    parallel_for_workers(calls.size(), [&](std::size_t i, std::size_t worker) {
        ++calls[i];
        sums.at(worker) += i;  // unguarded: the thread sanitizer would see two at once
    });
    EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), 1000);
    std::size_t sum = 0;
    for (const std::size_t part : sums) sum += part;
    EXPECT_EQ(sum, 999u * 500u);
}

}  // namespace
}  // namespace snug
