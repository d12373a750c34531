#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"

#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::area;
using test::bytes_of;
using test::expect_holds;
using test::good;
using test::refused;
using test::square_obj;

TEST(ReadObj, PolygonsOfAnyKindOfIndex) {
    for (const char* face :
         {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1/1 2/1 3/1 4/1", "f 1//1 2//1 3//1 4//1",
          "f 1/1/1 2/1/1 3/1/1 4/1/1", "f 1 2 \\\n 3 4", "f 1 2\\\n 3 4\r\n", "f +1 +2 +3 +4",
          "\tf  1 2 3 4 # four", "g a b\no c\nusemtl d\ns 1\nf 1 2 3 4\nl 1 2\np 1"}) {
        SCOPED_TRACE(face);
        const Mesh mesh = good(read_obj(bytes_of(square_obj(face))));
        EXPECT_EQ(mesh.triangles.size(), 2u);
        EXPECT_DOUBLE_EQ(area(mesh), 1);
    }
}

TEST(ReadObj, FacesMayComeBeforeTheirVerticesAndColoursAreSkipped) {
    const Mesh mesh = good(read_obj(bytes_of("f 1 2 3\nv 0 0 0 1 0 0\nv 1 0 0 0.5 0 0\nv 0 1 0 1 1 1\n")));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ReadObj, ConcavePolygonsAreCutInsideTheirOutline) {
    // A fan from the first corner would cover the notch.
    const Mesh mesh = good(read_obj(bytes_of("v 0 4 0\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nf 1 2 3 4 5\n")));
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_DOUBLE_EQ(area(mesh), 16 - 0.5 * 4 * 3);
    for (const auto& [a, b, c] : mesh.triangles) {
        Mesh one = mesh;
        one.triangles = {{a, b, c}};
        EXPECT_GT(area(one), 0);
    }
}

TEST(ReadObj, SaysWhichLineIsWrong) {
    expect_holds(refused(square_obj("f 1 2 9\n")), "line 5: the face wants vertex 9");
    expect_holds(refused(square_obj("f 0 1 2\n")), "line 5: \"0\" is no vertex number");
    expect_holds(refused(square_obj("f -5 -1 -2\n")), "line 5");
    expect_holds(refused(square_obj("f 1 2\n")), "1 of 1 faces have fewer than three corners");
    expect_holds(refused(square_obj("f 1 x 3\n")), "\"x\"");
    expect_holds(refused("v 0 0\nf 1 1 1\n"), "line 1: a vertex needs three numbers");
    expect_holds(refused("v 0 0 nan\nf 1 1 1\n"), "1 of 1 faces");
    expect_holds(refused("v 0 0 1e400\nf 1 1 1\n"), "1 of 1 faces");
    expect_holds(refused(square_obj("")), "point cloud");
    expect_holds(refused("# nothing\n", "a.obj"), "no triangles");
}

TEST(ReadObj, AByteOrderMarkDoesNotHideTheFirstVertex) {
    const Mesh mesh = good(read_mesh(bytes_of("\xef\xbb\xbf" + square_obj("f 1 2 3 4")), ""));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_DOUBLE_EQ(area(mesh), 1);
}

TEST(ReadObj, NegativeIndicesCountFromTheVerticesSoFar) {
    const Mesh mesh =
        good(read_obj(bytes_of(square_obj("f -4 -3 -2\nv 9 0 0\nv 9 1 0\nv 8 1 0\nf -3 -2 -1\n"))));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_FLOAT_EQ(mesh.vertices[3].x, 9);
}

TEST(ReadObj, TrianglesThatRepeatACornerAreKept) {
    EXPECT_EQ(good(read_obj(bytes_of(square_obj("f 1 2 3\nf 1 1 2\n")))).triangles.size(), 2u);
}

TEST(ReadObj, PolygonsThatWaitForTheirVerticesKeepTheOrderOfTheFile) {
    const Mesh mesh = good(read_obj(bytes_of(
        "f 4 3 2\nf 1 2 3 4\nf 2 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\nf 1 2 4\n")));
    EXPECT_EQ(
        mesh.triangles,
        (std::vector<Triangle>{{3, 2, 1}, {0, 1, 2}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2}, {0, 2, 3}, {0, 1, 3}}));
}

TEST(ReadObj, NumbersOfAnyLengthNameTheirVertex) {
    for (const char* face :
         {"f 01 0000000002 00000000000000000003", "f 1/9999999999999 2//x 3/", "f 1/\\\n 2 3"})
        EXPECT_EQ(good(read_obj(bytes_of(square_obj(face)))).triangles, (std::vector<Triangle>{{0, 1, 2}}))
            << face;
    for (const char* wrong :
         {"4294967295", "99999999999", "99999999999999999999", "1x", "/1", "-", "1.0", "--1"})
        expect_holds(refused(square_obj("f 1 2 " + std::string(wrong))), "line 5: \"" + std::string(wrong));
}

}  // namespace
}  // namespace snug
