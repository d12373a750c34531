#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"
#include "snug/formats/read_cloud.h"
#include "snug/words/words.h"

#include "tests/support/random.h"
#include "tests/support/read_checks.h"

// One bad item is no reason to refuse a file, nor to be silent about it.

namespace snug {
namespace {

using test::ascii_ply;
using test::bytes_of;
using test::expect_holds;
using test::good;
using test::keeps_promises;
using test::refused;

const std::vector<std::string> kNoNumbers{"nan",   "NaN",     "-nan",    "-nan(ind)", "inf",  "-Infinity",
                                          "1e999", "1.#QNAN", "-1.#IND", "1.#INF00",  "1e31", "-4e38"};

/// Each text format with `vertices` ("x y z" each) and triangles.
std::vector<std::string> in_every_format(const std::vector<std::string>& vertices,
                                         const std::vector<Triangle>& triangles) {
    std::string obj,
        off = "OFF\n" + std::to_string(vertices.size()) + " " + std::to_string(triangles.size()) + " 0\n",
        ply, stl = "solid a\n";
    for (const std::string& vertex : vertices) {
        obj += "v " + vertex + "\n";
        off += vertex + "\n";
        ply += vertex + "\n";
    }
    for (const auto& t : triangles) {
        const auto index = [&](std::uint32_t first) {
            return std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " +
                   std::to_string(t[2] + first) + "\n";
        };
        obj += "f " + index(1);
        off += "3 " + index(0);
        ply += "3 " + index(0);
        stl += "facet normal nan nan nan\nouter loop\n";
        for (const std::uint32_t v : t) stl += "vertex " + vertices[v] + "\n";
        stl += "endloop\nendfacet\n";
    }
    return {obj, off, stl + "endsolid a\n",
            ascii_ply(static_cast<int>(vertices.size()), static_cast<int>(triangles.size()), ply)};
}

const std::vector<Triangle> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

TEST(ReadLeftOut, AVertexThatNoFaceUsesMayBeNoNumber) {
    for (const std::string& none : kNoNumbers)
        for (const std::string& file :
             in_every_format({"0 0 0", "9 0 0", "0 9 0", "0 0 9", "1 " + none + " 3"}, kTetrahedron)) {
            SCOPED_TRACE(file);
            const Mesh mesh = good(read_mesh(bytes_of(file), ""));
            EXPECT_EQ(mesh.triangles.size(), 4u);
            EXPECT_EQ(mesh.vertices.size(), 4u);
            EXPECT_EQ(mesh.read.left_out_faces, 0u);
            EXPECT_EQ(mesh.read.faces, 4u);
        }
}

TEST(ReadLeftOut, FacesWithACornerThatIsNoNumberAreLeftOutAndCounted) {
    std::vector<Triangle> triangles = kTetrahedron;
    triangles.push_back({0, 1, 4});
    for (const std::string& none : kNoNumbers)
        for (const std::string& file :
             in_every_format({"0 0 0", "9 0 0", "0 9 0", "0 0 9", none + " 2 3"}, triangles)) {
            SCOPED_TRACE(file);
            const Mesh mesh = good(read_mesh(bytes_of(file), ""));
            EXPECT_TRUE(keeps_promises(mesh));
            EXPECT_EQ(mesh.triangles.size(), 4u);
            EXPECT_EQ(mesh.vertices.size(), 4u);
            EXPECT_EQ(mesh.read.left_out_faces, 1u);
            EXPECT_EQ(mesh.read.faces, 5u);
        }
}

TEST(ReadLeftOut, MoreThanHalfOfTheFacesIsTooMuch) {
    for (int seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(static_cast<std::uint64_t>(seed));
        std::vector<std::string> vertices;
        std::vector<Triangle> triangles;
        std::size_t wrong = 0;
        const auto faces = static_cast<std::uint32_t>(random.integer(1, 12));
        for (std::uint32_t f = 0; f < faces; ++f) {
            const bool bad = random.chance(0.5);
            wrong += bad;
            for (int corner = 0; corner < 3; ++corner)
                vertices.push_back(std::to_string(random.integer(-99, 99)) + " " + std::to_string(corner) +
                                   " " + (bad && corner == random.integer(0, 2) % 3 ? "nan" : "7"));
            if (bad) vertices.back() = "1 nan 1";
            triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
        }
        for (const std::string& file : in_every_format(vertices, triangles)) {
            const auto mesh = read_mesh(bytes_of(file), "");
            ASSERT_EQ(mesh.has_value(), 2 * wrong <= faces) << file;
            if (!mesh) {
                expect_holds(text(mesh.error().message),
                             std::to_string(wrong) + " of " + std::to_string(faces));
                continue;
            }
            EXPECT_EQ(mesh->read.left_out_faces, wrong);
            EXPECT_EQ(mesh->triangles.size(), faces - wrong);
        }
    }
}

TEST(ReadLeftOut, FacesOfFewerThanThreeCornersAreCountedAndTheirIndicesDoNotMatter) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (const char* bad :
         {"f\n", "f 1\n", "f 1 2\n", "f 1// 2//\n", "f 1 99\n", "f  # nothing\n", "fo 3 \\\n 4\n"}) {
        SCOPED_TRACE(bad);
        const Mesh mesh = good(read_obj(bytes_of(square + bad + "f 1 2 3 4\n")));
        EXPECT_EQ(mesh.triangles.size(), 2u);
        EXPECT_EQ(mesh.read.left_out_faces, 1u);
        EXPECT_EQ(mesh.read.faces, 2u);
    }
    expect_holds(refused(square + "f 1 2\nf 1 2 9\n"), "wants vertex 9");
    const Mesh off = good(read_off(bytes_of("OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n3 0 1 2\n3 2 1 0\n")));
    EXPECT_EQ(off.read.left_out_faces, 1u);
    const Mesh ply =
        good(read_ply(bytes_of(ascii_ply(3, 4, "0 0 0\n1 0 0\n0 1 0\n2 0 1\n0\n3 0 1 2\n3 2 1 0\n"))));
    EXPECT_EQ(ply.read.left_out_faces, 2u);
    EXPECT_EQ(ply.triangles.size(), 2u);
}

TEST(ReadLeftOut, APolygonWithABadCornerIsOneFaceWhereverItsVerticesStand) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv nan 0 0\n",
                      faces = "f 1 2 5 3 4\nf 1 2 3 4\n";
    for (const std::string& file : {vertices + faces, faces + vertices}) {
        const Mesh mesh = good(read_obj(bytes_of(file)));
        EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}})) << file;
        EXPECT_EQ(mesh.read.left_out_faces, 1u);
    }
}

TEST(ReadLeftOut, PointsOfACloudThatAreNoNumbersAreLeftOutInEveryFormat) {
    for (const std::string& none : kNoNumbers) {
        const std::string rows[] = {"1 2 3", "4 5 6", none + " " + none + " " + none, "7 8 9"};
        std::string xyz, obj, pts = "4\n";
        for (const std::string& row : rows) {
            xyz += row + "\n";
            obj += "v " + row + "\n";
            pts += row + " 1 2 3 4\n";
        }
        for (const auto& [text, name] :
             std::vector<std::pair<std::string, std::string>>{{xyz, "a.xyz"},
                                                              {pts, "a.pts"},
                                                              {obj, ""},
                                                              {ascii_ply(4, 0, xyz), ""},
                                                              {"OFF\n4 0 0\n" + xyz, ""}}) {
            SCOPED_TRACE(text);
            const Mesh cloud = good(read_mesh_or_cloud(bytes_of(text), name));
            EXPECT_TRUE(cloud.is_cloud());
            EXPECT_EQ(cloud.vertices, (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
            EXPECT_EQ(cloud.read.left_out_points, 1u);
        }
    }
}

}  // namespace
}  // namespace snug
