#include "snug/formats/shape_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/mesh/measure.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"
#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::expect_holds;

constexpr double kPi = std::numbers::pi;

Mesh shaped(std::string_view text) {
    return test::good(read_mesh(test::bytes_of(text), "a.shape"));
}

std::string wrong(std::string_view text) {
    return test::refused(text, "a.shape");
}

void expect_closed(const Mesh& mesh, double volume, double share, const std::string& of) {
    const MeshMeasure measured = measure(mesh);
    ASSERT_TRUE(measured.volume.has_value()) << of;
    EXPECT_NEAR(*measured.volume, volume, share * volume) << of;
    for (const Triangle& t : mesh.triangles) {
        const Vec3f a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        EXPECT_FALSE(a == b || b == c || c == a) << of;
    }
    EXPECT_TRUE(test::keeps_promises(mesh)) << of;
    EXPECT_TRUE(mesh.read.in_mm);
}

TEST(ShapeText, TheVolumesAreThoseOfTheFormulas) {
    expect_closed(shaped("box 10x20x30"), 6000, 1e-6, "box");
    expect_closed(shaped("cylinder 63x60"), kPi / 4 * 63 * 63 * 60, 2e-3, "cylinder");
    expect_closed(shaped("cone 80x40x120"), kPi * 120 / 12 * (80 * 80 + 80 * 40 + 40 * 40), 2e-3, "cone");
    expect_closed(shaped("cone 80x0x120"), kPi * 120 / 12 * 80 * 80, 2e-3, "tip");
    expect_closed(shaped("cone 0.1x80x120 along x"), kPi * 120 / 12 * 80 * 80, 4e-3, "upside down");
    expect_closed(shaped("ball 70"), kPi / 6 * 70 * 70 * 70, 3e-3, "ball");
    // Sides less the corners: a box within, six plates, twelve quarters of a cylinder, a ball.
    const double r = 5, x = 143 - 2 * r, y = 87 - 2 * r, z = 40 - 2 * r;
    const double rounded =
        x * y * z + 2 * r * (x * y + y * z + z * x) + kPi * r * r * (x + y + z) + 4 * kPi / 3 * r * r * r;
    expect_closed(shaped("box 143x87x40 r5"), rounded, 1e-3, "rounded");
    expect_closed(shaped("box 143x87x40 r5 + cylinder 63x60 at 0,0,50"), rounded + kPi / 4 * 63 * 63 * 60,
                  2e-3, "camera");
}

TEST(ShapeText, PartsStandWhereTheyArePut) {
    const auto box = [](std::string_view text) { return bounds(shaped(text)); };
    EXPECT_EQ(box("box 10x20x30 at 1,2,3").min, (Vec3d{-4, -8, -12}));
    EXPECT_EQ(box("box 10x20x30 at 1,2,3").max, (Vec3d{6, 12, 18}));
    EXPECT_EQ(box("cylinder 20x60").size(), (Vec3d{20, 20, 60}));
    EXPECT_EQ(box("cylinder 20x60 along x").size(), (Vec3d{60, 20, 20}));
    EXPECT_EQ(box("cylinder 20x60 along y at 0,30,0").max, (Vec3d{10, 60, 10}));
    EXPECT_EQ(box("box 10x20x30 turn 0,0,90").size(), (Vec3d{20, 10, 30}));
}

TEST(ShapeText, BlanksCapitalsAndCommentsDoNotMatter) {
    const auto one = parse_shape("box 143x87x40 r5 + cylinder 63x60 at 0,0,50");
    const auto other =
        parse_shape("# a camera\n  Box 143 X 87 x 40.0 R 5\n+Cylinder 63x60 AT 0, 0 ,50 # lens\n");
    ASSERT_TRUE(one && other);
    EXPECT_EQ(*one, *other);
}

TEST(ShapeText, RandomShapesAreClosedAndReadBack) {
    test::Random random(2211);
    for (int i = 0; i < test::cases(40); ++i) {
        std::vector<SimpleSolid> solids(1 + static_cast<std::size_t>(random.integer(0, 3)));
        for (SimpleSolid& solid : solids) {
            const auto tenths = [&](int least, int most) { return random.integer(least, most) / 10.0; };
            solid.kind = static_cast<SolidKind>(random.integer(0, 3));
            solid.size_mm = {tenths(1, 3000), tenths(1, 3000), tenths(1, 3000)};
            if (solid.kind != SolidKind::box) solid.size_mm.y = solid.size_mm.x;
            if (solid.kind == SolidKind::ball) solid.size_mm.z = solid.size_mm.x;
            if (solid.kind == SolidKind::box && random.integer(0, 1) == 1)
                solid.radius_mm =
                    std::floor(std::min({solid.size_mm.x, solid.size_mm.y, solid.size_mm.z}) * 5) / 10;
            if (solid.kind == SolidKind::cone) solid.top_mm = random.integer(0, 2) == 0 ? 0 : tenths(1, 3000);
            if (solid.kind == SolidKind::cone || solid.kind == SolidKind::cylinder)
                solid.along = "xyz"[random.integer(0, 2)];
            if (random.integer(0, 1) == 1)
                solid.turn_deg = {tenths(-3600, 3600), tenths(-900, 900), tenths(0, 900)};
            if (random.integer(0, 1) == 1)
                solid.centre_mm = {tenths(-500, 500), tenths(-500, 500), tenths(-500, 500)};
        }
        const std::string text = shape_text(solids);
        const auto again = parse_shape(text);
        ASSERT_TRUE(again.has_value()) << text;
        EXPECT_EQ(*again, solids) << text;
        const MeshMeasure measured = measure(shaped(text));
        EXPECT_TRUE(measured.volume && *measured.volume > 0) << text;
    }
}

TEST(ShapeText, WhatIsWrongIsSaidWithItsPart) {
    expect_holds(wrong("box"), "part 1: its size in mm");
    expect_holds(wrong("# nothing\n"), "such as `box 143x87x40");
    expect_holds(wrong("box 10x20"), "box 143x87x40");
    expect_holds(wrong("ball 7 + cylinder 3,5x8"), "part 2: its size");
    expect_holds(wrong("ball 0"), "0.1 to 10,000 mm, not 0");
    expect_holds(wrong("cone 0x10x10"), "not 0");
    expect_holds(wrong("ball 10001"), "not 10001");
    expect_holds(wrong("ball 7 r3"), "part 1: \"r3\" is not understood");
    expect_holds(wrong("box 10x20x30 r6"), "a radius of 6 mm does not fit; up to 5 mm does");
    expect_holds(wrong("ball 7 at 0,0,10001"), "10001 is beyond 10000");
    expect_holds(wrong("ball 7 along x"), "\"along\" is not understood");
    expect_holds(wrong("ball 7 ball 8"), "\"ball\" is not understood");
    expect_holds(wrong("ball 7 +"), "part 2 is missing behind the +");
    expect_holds(wrong("ball 7 at 0,0"), "\"at\" is not understood");
    std::string many = "ball 1";
    for (int i = 0; i < 100; ++i) many += "+ball 1";
    expect_holds(wrong(many), "more than 100 parts");
}

}  // namespace
}  // namespace snug
