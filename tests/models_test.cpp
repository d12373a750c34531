#include "tests/support/models.h"

#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/solid/solid.h"
#include "snug/words/words.h"

#include "tests/support/brute_force.h"
#include "tests/support/cases.h"
#include "tests/support/random_design.h"
#include "tests/support/solid_checks.h"

// Real scans at the paper's resolutions and a fine one.

namespace snug {
namespace {

struct Model {
    const char* name;
    bool closed;
};

void PrintTo(const Model& model, std::ostream* stream) {
    *stream << model.name;
}

constexpr double kDiagonal = 240;  // mm

std::optional<Mesh> load(const char* name) {
    const auto bytes = test::model_file(name);
    if (!bytes) return {};
    Mesh mesh = read_mesh(*bytes, name).value();
    const Vec3d size = bounds(mesh).size();
    return scaled(std::move(mesh), kDiagonal / std::sqrt(dot(size, size)));
}

Design design_of(Vec3i blocks, Vec3d rotation) {
    Design design;
    design.object.units = Unit::mm;
    design.space.blocks = blocks;
    const double side = kDiagonal * 1.35;
    design.space.block_mm = {side / blocks.x, side / blocks.y, side / blocks.z};
    design.placement.rotation_deg = rotation;
    return design;
}

class Models : public testing::TestWithParam<Model> {};

TEST_P(Models, AreCutExactlyAndComeOutOfClosedFoams) {
    const auto mesh = load(GetParam().name);
    if (!mesh) GTEST_SKIP() << "the shared models are not here";
    const auto object = prepare(*mesh, design_of({8, 8, 8}, {}));
    ASSERT_TRUE(object.has_value());
    const Vec3i resolutions[] = {{8, 8, 8},    {12, 8, 8},   {6, 10, 10},  {10, 10, 10},
                                 {15, 15, 15}, {20, 20, 20}, {25, 25, 25}, {30, 30, 30}};
    const Vec3d rotations[] = {{0, 0, 0}, {90, 0, -90}, {33, -71, 158}};
    for (const Vec3i& n : resolutions) {
        for (const Vec3d& rotation : rotations) {
            SCOPED_TRACE(testing::Message() << n.x << "x" << n.y << "x" << n.z << " turned " << rotation.x);
            const auto packing = pack(*object, design_of(n, rotation));
            ASSERT_TRUE(packing && packing->foams);
            const auto& [space, foams] = std::tie(packing->space, *packing->foams);
            EXPECT_EQ(packing->fit.lower().blocks + packing->fit.upper().blocks + packing->fit.cut_blocks,
                      space.block_count());
            test::expect_solid_of(foams, Half::lower, space);
            test::expect_solid_of(foams, Half::lid, space);
            for (const Finding& finding : packing->findings) {
                EXPECT_NE(finding.code(), "uncut_part") << text(finding.message);
                EXPECT_TRUE(!GetParam().closed || finding.code() != "open") << text(finding.message);
            }
        }
    }
}

TEST_P(Models, EqualTheBruteForceOnACoarseGrid) {
    const auto mesh = load(GetParam().name);
    if (!mesh) GTEST_SKIP() << "the shared models are not here";
    const auto object = prepare(*mesh, design_of({8, 8, 8}, {}));
    int left = test::cases_at_most(3);
    for (const double clearance : {-3.0, 2.0, 0.0}) {
        if (left-- <= 0) break;
        Design design = design_of({12, 7, 8}, {12, 34, 56});
        design.cut.clearance_mm = clearance;
        const auto packing = pack(*object, design);
        const auto expected =
            test::brute_force_cut(test::placed_triangles(object->mesh, packing->items.front().placement),
                                  packing->space, clearance, false);
        for (int j = 0; j < 7; ++j)
            for (int k = 0; k < 8; ++k)
                for (int i = 0; i < 12; ++i) {
                    const CutRun run = packing->layers.front()(j, k);
                    ASSERT_EQ(i >= run.first && i < run.end, expected.cut(i, j, k))
                        << i << " " << j << " " << k;
                }
    }
}

TEST_P(Models, AreCutFinely) {
    const auto mesh = load(GetParam().name);
    if (!mesh) GTEST_SKIP() << "the shared models are not here";
    const auto object = prepare(*mesh, design_of({8, 8, 8}, {}));
    const auto packing = pack(*object, design_of({300, 180, 180}, {33, -71, 158}));
    ASSERT_TRUE(packing && packing->foams);
    test::expect_solid_of(*packing->foams, Half::lower, packing->space);
    test::expect_solid_of(*packing->foams, Half::lid, packing->space);
    // The finer the blocks, the nearer the cut comes to the object itself, from outside.
    EXPECT_GT(static_cast<double>(packing->fit.cut_blocks) * packing->space.block_volume(),
              object->measure.volume.value_or(0));
}

INSTANTIATE_TEST_SUITE_P(Shared, Models,
                         testing::Values(Model{"stanford-bunny.obj", false}, Model{"armadillo.obj", true},
                                         Model{"spot.obj", true}, Model{"teapot.obj", false},
                                         Model{"cow.obj", true}, Model{"beetle-alt.obj", false},
                                         Model{"camelhead.off", false}, Model{"screwdriver.off", true}),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             name.resize(name.find_first_of("-."));
                             return name;
                         });

TEST(Bunny, WithoutItsBaseIsADangerAndCappedIsCutWhereTheClosedOneIs) {
    const auto mesh = load("stanford-bunny.obj");
    if (!mesh) GTEST_SKIP() << "the shared models are not here";
    // The base stands on the plane of least y; take away what faces it there.
    const double floor = bounds(*mesh).min.y + 0.03 * bounds(*mesh).size().y;
    RawMesh raw;
    for (const Vec3f& v : mesh->vertices) raw.vertices.push_back(vec_cast<double>(v));
    for (const Triangle& t : mesh->triangles) {
        const Vec3d a = raw.vertices[t[0]], b = raw.vertices[t[1]], c = raw.vertices[t[2]];
        const Vec3d normal = cross(b - a, c - a);
        const bool low = a.y < floor && b.y < floor && c.y < floor;
        if (!low || normal.y > -0.7 * std::sqrt(dot(normal, normal))) raw.triangles.push_back(t);
    }
    ASSERT_LT(raw.triangles.size(), mesh->triangles.size());
    const Mesh open = finish(std::move(raw)).value();
    for (const double turn : {0.0, 90.0, -90.0, 37.0}) {
        SCOPED_TRACE(turn);
        Design design = design_of({24, 24, 24}, {0, 0, turn});
        const Packing closed = *pack(*prepare(*mesh, design), design);
        const Packing lost = *pack(*prepare(open, design), design);
        if (turn == 90 || turn == -90) {
            EXPECT_EQ(lost.findings.front().code(), "open");
        }
        design.object.cap = true;
        const Packing capped = *pack(*prepare(open, design), design);
        for (const Finding& finding : capped.findings) EXPECT_NE(finding.code(), "open");
        for (std::size_t column = 0; column < closed.layers.front().size(); ++column) {
            const CutRun whole = closed.layers.front()[column], mended = capped.layers.front()[column];
            if (whole.none()) continue;
            EXPECT_LE(mended.first, whole.first);
            EXPECT_GE(mended.end, whole.end);
        }
    }
}

}  // namespace
}  // namespace snug
