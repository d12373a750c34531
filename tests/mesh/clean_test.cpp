#include "snug/mesh/clean.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/make.h"
#include "snug/object/clean_object.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/models.h"
#include "tests/support/random_design.h"

// Parts dropped from a scan, and what stands behind a plane.

namespace snug {
namespace {

using test::Random;

void append(Mesh& mesh, const Mesh& more, Vec3f shift) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3f& v : more.vertices) mesh.vertices.push_back(v + shift);
    for (const Triangle& t : more.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

Mesh speck(float side) {
    return {{{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, side}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
            {}};
}

Design plain() {
    Design design;
    design.object.units = Unit::mm;
    return design;
}

bool has(const std::vector<Finding>& findings, std::string_view code) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code() == code; });
}

TEST(Clean, AScanWithoutItsSpecksHasTheFoamsOfTheObjectAlone) {
    const Mesh vase = *sample("vase");
    Mesh scan = vase;
    append(scan, speck(1), {50, 60, 70});
    append(scan, speck(2), {-50, -60, 70});
    append(scan, speck(30), {60, 20, -70});
    Design design = plain();
    const auto alone = pack(*prepare(vase, design), design);
    EXPECT_FALSE(has(alone->findings, "dropped"));
    const auto dirty = pack(*prepare(scan, design), design);
    EXPECT_FALSE(has(dirty->findings, "dropped"));

    design.object.clean.drop_below_mm = 2.5;
    design.object.clean.drop_parts = {2};
    const auto object = prepare(scan, design);
    ASSERT_TRUE(object.has_value());
    ASSERT_EQ(object->clean.dropped.size(), 3u);
    EXPECT_EQ(object->clean.dropped[0].number, 2u);
    EXPECT_EQ(object->clean.dropped[0].triangles, 4u);
    EXPECT_EQ(object->mesh.vertices, vase.vertices);
    EXPECT_EQ(object->read.triangles, scan.triangles.size());
    const auto clean = pack(*object, design);
    EXPECT_TRUE(has(clean->findings, "dropped"));
    EXPECT_EQ(clean->foams->pieces, alone->foams->pieces);
}

TEST(Clean, SharesAreThoseOfTheSurface) {
    Mesh mesh = speck(2);
    append(mesh, speck(4), {100, 0, 0});
    const auto shares = part_shares(mesh, measure(mesh));
    ASSERT_EQ(shares.size(), 2u);
    EXPECT_NEAR(shares[0].share, 0.8, 1e-12);
    EXPECT_NEAR(shares[1].share, 0.2, 1e-12);
}

TEST(Clean, WhatCannotBeDroppedIsASentence) {
    Design design = plain();
    const Mesh torus = *sample("torus");
    const auto refused = [&] {
        const auto object = prepare(torus, design);
        return object ? std::string() : text(object.error().message);
    };
    design.object.clean.drop_parts = {2};
    EXPECT_NE(refused().find("there is no part 2 to drop: the object has 1 part"), std::string::npos);
    design.object.clean.drop_parts = {1};
    EXPECT_NE(refused().find("every part"), std::string::npos);
    design.object.clean = {};
    design.object.clean.drop_below_mm = 5000;
    EXPECT_NE(refused().find("every part"), std::string::npos);
    design.object.clean = {};
    design.object.clean.cut_plane = {{0, 0, 1, 900}};
    EXPECT_NE(refused().find("behind the cutting plane"), std::string::npos);
    design.object.clean.cut_plane = {{0, 0, 0, 1}};
    EXPECT_FALSE(checked(design));
    design.object.clean.cut_plane = {{1, 0, 0, std::nan("")}};
    EXPECT_FALSE(checked(design));
    design.object.clean = {};
    design.object.clean.drop_parts = {0};
    EXPECT_FALSE(checked(design));
}

/// The two sides of a closed object make the whole, and both are closed again.
void expect_halves(const Mesh& mesh, Vec3d normal, double distance) {
    const double whole = *measure(mesh).volume;
    double sum = 0;
    for (const double side : {1.0, -1.0}) {
        const Mesh half = cut_off(mesh, normal * side, distance * side);
        if (half.triangles.empty()) continue;
        const MeshMeasure measured = measure(half);
        EXPECT_TRUE(measured.watertight);
        ASSERT_TRUE(measured.volume.has_value());
        sum += *measured.volume;
        for (const Vec3f& v : half.vertices)
            EXPECT_GE(side * (dot(normal, vec_cast<double>(v)) - distance), -1e-3);
    }
    EXPECT_NEAR(sum, whole, 1e-4 * std::fabs(whole));
}

TEST(Clean, BothSidesOfAPlaneMakeTheWhole) {
    for (const std::string_view name : sample_names()) {
        SCOPED_TRACE(std::string(name));
        const Mesh mesh = *sample(name);
        Random random(3);
        for (int turn = 0; turn < 12; ++turn) {
            Vec3d normal{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
            normal = normal * (1 / std::sqrt(dot(normal, normal)));
            const Vec3d through = bounds(mesh).centre() + normal * random.between(-20, 20);
            expect_halves(mesh, normal, dot(normal, through));
        }
        // Through vertices, so that many of them lie in the plane.
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d normal;
            normal[axis] = 1;
            expect_halves(mesh, normal, static_cast<double>(mesh.vertices[mesh.vertices.size() / 3][axis]));
        }
    }
}

TEST(Clean, RandomSoupsAreCutWithoutHarm) {
    for (int seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Mesh mesh = test::random_design(random).mesh;
        const Vec3d normal{random.between(-1, 1), random.chance(0.5) ? 0 : random.between(-1, 1), 0.25};
        const Vec3f through = mesh.vertices[static_cast<std::size_t>(
            random.integer(0, static_cast<int>(mesh.vertices.size()) - 1))];
        const Mesh half = cut_off(mesh, normal, dot(normal, vec_cast<double>(through)));
        std::vector<bool> used(half.vertices.size(), false);
        for (const Triangle& t : half.triangles)
            for (const std::uint32_t v : t) {
                ASSERT_LT(v, half.vertices.size());
                used[v] = true;
            }
        EXPECT_EQ(std::find(used.begin(), used.end(), false), used.end());
    }
}

TEST(Clean, ATableIsCutAwayInTheFilesOwnCoordinates) {
    Mesh scan = *sample("figurine");
    const Box3d box = bounds(scan);
    scan.origin = {1000, 2000, 3000};
    Design design = plain();
    design.object.clean.cut_plane = {{2, 0, 0, 1000 + box.min.x + 20}};
    const auto object = prepare(scan, design);
    ASSERT_TRUE(object.has_value());
    EXPECT_TRUE(object->clean.plane_cut);
    EXPECT_TRUE(object->measure.watertight);
    EXPECT_NEAR(object->measure.bounds.min.x, box.min.x + 20, 1e-3);
    EXPECT_NEAR(object->measure.bounds.max.x, box.max.x, 1e-3);
    const auto packing = pack(*object, design);
    EXPECT_TRUE(has(packing->findings, "cut_off"));
    EXPECT_FALSE(has(packing->findings, "open"));
}

}  // namespace
}  // namespace snug
