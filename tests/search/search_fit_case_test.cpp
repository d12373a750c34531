#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/search/fit_case.h"
#include "snug/search/turn.h"
#include "snug/space/fitted_space.h"
#include "snug/space/placement.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/models.h"
#include "tests/support/optimal_box.h"
#include "tests/support/random.h"
#include "tests/support/search_designs.h"
#include "tests/support/shapes.h"

namespace snug {
namespace {

using test::Random;

Design case_design(double clearance, double wall, Vec3d block = {15, 15, 22}) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks.reset();
    design.space.block_mm = block;
    design.space.wall_mm = equal_walls(wall);
    design.cut.clearance_mm = clearance;
    return design;
}

long long total(Vec3i blocks) {
    return 1LL * blocks.x * blocks.y * blocks.z;
}

/// The fewest blocks of the six ways to lay a box along the axes.
long long best_of_six(Vec3d box, const Design& design) {
    std::array<int, 3> order{0, 1, 2};
    long long best = std::numeric_limits<long long>::max();
    do {
        long long blocks = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double size = design.space.block_mm[axis];
            const double length = box[order[static_cast<std::size_t>(axis)]];
            blocks *= static_cast<long long>(
                std::ceil((length + 2 * design.cut.clearance_mm.lower.x - 0.02) / size) +
                2 * std::ceil(design.space.wall_mm->front() / size));
        }
        best = std::min(best, blocks);
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

/// The case holds the object with its walls: by the pipeline, which fits the space itself.
void expect_holds(const Mesh& mesh, Design design, const FittedCase& fitted) {
    design.placement.rotation_deg = fitted.rotation_deg;
    const auto object = prepare(mesh, design);
    ASSERT_TRUE(object);
    const auto fitted_packing = pack(*object, design);
    ASSERT_TRUE(fitted_packing);
    EXPECT_EQ(fitted_packing->space.blocks, fitted.blocks);
    design.space.blocks = fitted.blocks;
    const auto packing = pack(*object, design);
    ASSERT_TRUE(packing && packing->foams);
    for (const double wall : packing->fit.wall_mm) EXPECT_GE(wall, design.space.wall_mm->front());
}

Mesh with_diagonal(Mesh mesh, double diagonal) {
    const Vec3d size = bounds(mesh).size();
    return scaled(std::move(mesh), diagonal / std::sqrt(dot(size, size)));
}

/// `designs`: how many of three kinds of foam are tried.
void expect_no_larger_than_the_optimal_box(const Mesh& mesh, int designs = 3) {
    const Vec3d box = test::optimal_box(mesh);
    for (const auto& [clearance, wall, block] :
         {std::tuple{0.0, 50.0, Vec3d{15, 15, 22}}, std::tuple{2.0, 0.0, Vec3d{10, 10, 10}},
          std::tuple{0.0, 20.0, Vec3d{25.4, 12.7, 12.7}}}) {
        if (designs-- <= 0) break;
        const Design design = case_design(clearance, wall, block);
        const auto fitted = fit_case(mesh, design, 1);
        ASSERT_TRUE(fitted);
        EXPECT_LE(total(fitted->blocks), best_of_six(box, design)) << block.x << " " << block.y;
        expect_holds(mesh, design, *fitted);
    }
}

TEST(FitCase, NeedsNoMoreBlocksThanCgalsOptimalBoxOnSamples) {
    int left = test::cases_at_most(4, 2);
    for (const std::string_view name : sample_names()) {
        if (left-- == 0) break;
        SCOPED_TRACE(name);
        expect_no_larger_than_the_optimal_box(with_diagonal(*sample(name), 240), 1);
    }
}

TEST(FitCase, NeedsNoMoreBlocksThanCgalsOptimalBoxOnRealObjects) {
    int read = 0;
    for (const char* name : {"armadillo.obj", "beetle-alt.obj", "camelhead.off", "cow.obj", "screwdriver.off",
                             "spot.obj", "stanford-bunny.obj", "teapot.obj"}) {
        SCOPED_TRACE(name);
        const auto bytes = test::model_file(name);
        if (!bytes || read == test::cases_at_most(8, 2)) continue;
        ++read;
        expect_no_larger_than_the_optimal_box(with_diagonal(*read_mesh(*bytes, name), 240), 1);
    }
    if (read == 0) GTEST_SKIP() << "the shared models are not here";
}

TEST(FitCase, NeedsNoMoreBlocksThanCgalsOptimalBoxOnRandomPoints) {
    for (int seed = 0; seed < test::cases(6, 2); ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        Mesh mesh;
        const Vec3d half{random.between(10, 120), random.between(10, 120), random.between(10, 120)};
        for (std::uint32_t i = 0; i < 30; ++i) {
            Vec3f v;
            for (int axis = 0; axis < 3; ++axis)
                v[axis] = static_cast<float>(random.between(-half[axis], half[axis]));
            mesh.vertices.push_back(v);
            if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
        }
        expect_no_larger_than_the_optimal_box(test::turned(mesh, test::random_turn(random)));
    }
}

TEST(FitCase, ABoxTurnedAtRandomGetsItsOwnBlocks) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Mesh box = test::turned(test::box_mesh({0, 0, 0}, {60, 45, 66}), test::random_turn(random));
        const Design design = case_design(0, 0);
        const auto fitted = fit_case(box, design, seed);
        ASSERT_TRUE(fitted);
        EXPECT_EQ(total(fitted->blocks), 4 * 3 * 3);
        expect_holds(box, design, *fitted);
    }
}

TEST(FitCase, IsNeverLargerThanTheCaseOfTheRotationThatStands) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Mesh mesh = *sample("camera");
        Design design = case_design(random.between(0, 3), random.between(0, 60));
        for (int axis = 0; axis < 3; ++axis) design.placement.rotation_deg[axis] = random.between(-180, 180);
        const Box3d box = place(mesh, design.placement.rotation_deg, {}).bounds;
        const Vec3d stands =
            fitted_blocks(grown(box, design.cut.clearance_mm), design.space.block_mm, *design.space.wall_mm);
        const auto fitted = fit_case(mesh, design, seed);
        ASSERT_TRUE(fitted);
        EXPECT_LE(total(fitted->blocks), total(vec_cast<int>(stands)));
    }
}

TEST(FitCase, LeastBilledWeightIsNeverBilledMoreThanLeastVolume) {
    const auto billed = [](const FittedCase& fitted, const Design& design) {
        double cm3 = 1;
        for (int axis = 0; axis < 3; ++axis)
            cm3 *= std::ceil(fitted.blocks[axis] * design.space.block_mm[axis] / 10 - 1e-9);
        return std::ceil(2 * cm3 / design.search.billed_divisor - 1e-9) / 2;
    };
    for (const std::string_view name : {"torus", "camera"}) {
        Design design = case_design(0, 50, {9, 13, 17});
        const auto smallest = fit_case(*sample(name), design, 1);
        design.search.case_goal = CaseGoal::billed_weight;
        const auto lightest = fit_case(*sample(name), design, 1);
        ASSERT_TRUE(smallest && lightest);
        EXPECT_LE(billed(*lightest, design), billed(*smallest, design)) << name;
    }
}

TEST(FitCase, AnAxisThatIsKeptUprightPointsAlongX) {
    Design design = case_design(0, 10);
    for (const Upright upright : {Upright::plus_z, Upright::minus_y, Upright::plus_x, Upright::minus_x}) {
        design.search.upright = upright;
        const auto fitted = fit_case(*sample("camera"), design, 3);
        ASSERT_TRUE(fitted);
        const Vec3d up = rotation_from_euler(fitted->rotation_deg)(direction(upright));
        EXPECT_NEAR(up.x, 1, 1e-6);
        expect_holds(*sample("camera"), design, *fitted);
    }
}

TEST(FitCase, ARotationThatFitsIsFoundAndWhatIsInTheWayIsSaid) {
    const Mesh rod = test::turned(test::box_mesh({0, 0, 0}, {100, 10, 10}), turn_about({1, 2, 3}, 40));
    Design design = case_design(0, 0, {10, 10, 10});
    const auto rotation = fitting_rotation(rod, design, {{2, 11, 2}, {10, 10, 10}}, 1);
    ASSERT_TRUE(rotation);
    EXPECT_LE(place(rod, *rotation, {}).bounds.size().x, 20.02);
    const auto none = fitting_rotation(rod, design, {{5, 5, 5}, {10, 10, 10}}, 1);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::does_not_fit);
    EXPECT_NE(text(none.error().message).find("too long by"), std::string::npos)
        << text(none.error().message);
}

TEST(FitCase, TooManyBlocksAreSaidAndCancelledItIsTheBestSoFar) {
    Design design = case_design(0, 50, {0.1, 0.1, 0.1});
    const Mesh box = test::box_mesh({0, 0, 0}, {500, 500, 500});
    const auto fitted = fit_case(box, design, 1);
    ASSERT_FALSE(fitted);
    EXPECT_EQ(fitted.error().kind, ErrorKind::usage);
    design = case_design(0, 50);
    const auto cancelled = fit_case(*sample("figurine"), design, 1, [](double) { return false; });
    ASSERT_TRUE(cancelled);
    expect_holds(*sample("figurine"), design, *cancelled);
}

}  // namespace
}  // namespace snug
