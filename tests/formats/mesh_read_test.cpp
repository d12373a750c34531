#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/mesh_files.h"
#include "snug/formats/read.h"
#include "snug/words/words.h"

#include "tests/support/models.h"
#include "tests/support/random.h"
#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::bytes_of;
using test::expect_holds;
using test::good;
using test::keeps_promises;
using test::Random;
using test::refused;
using test::square_obj;
using test::stl_of;
using test::tetrahedron;

TEST(ReadMesh, TheContentTellsTheFormatBeforeTheName) {
    EXPECT_EQ(read_mesh(bytes_of(square_obj("f 1 2 3")), "a.stl").value().triangles.size(), 1u);
    EXPECT_EQ(mesh_format(bytes_of(stl_of(tetrahedron())), "a.obj").value(), MeshFormat::stl);
    EXPECT_EQ(mesh_format(bytes_of("ply\nwhatever"), "a.off").value(), MeshFormat::ply);
    EXPECT_EQ(mesh_format(bytes_of("whatever"), "A.OFF").value(), MeshFormat::off);
}

TEST(ReadMesh, OtherFormatsAreNamedWithWhatToDo) {
    expect_holds(refused(""), "empty");
    expect_holds(refused("PK\x03\x04..."), "3MF");
    expect_holds(refused("glTF\x02"), "glTF");
    expect_holds(refused("ISO-10303-21;"), "STEP");
    expect_holds(refused("Kaydara FBX Binary  "), "FBX");
    expect_holds(refused("Dear diary,", "diary.txt"), "STL, OBJ, PLY, OFF, glTF, 3MF");
    expect_holds(refused("ASTM-E57"), "E57");
    expect_holds(refused("LASF"), "LAS");
}

TEST(ReadMesh, UnusedVerticesDoNotCount) {
    const Mesh mesh = good(read_obj(bytes_of("v 999 999 999\n" + square_obj("f 2 3 4\nv 5 5 5\n"))));
    EXPECT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ReadMesh, SurveyCoordinatesKeepTheirDetailInEveryTextFormat) {
    const char* corners[] = {"403210.001 3204000.002 100.003", "403210.101 3204000.002 100.003",
                             "403210.001 3204000.052 100.003"};
    const auto file = [&](const std::string& before, const char* each, const std::string& after) {
        std::string text = before;
        for (const char* corner : corners) text += std::string(each) + corner + "\n";
        return text + after;
    };
    for (const std::string& text :
         {file("", "v ", "f 1 2 3\n"), file("OFF\n3 1 0\n", "", "3 0 1 2\n"),
          file("solid s\nfacet normal 0 0 1\nouter loop\n", "vertex ", "endloop\nendfacet\nendsolid s\n"),
          file("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
               "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
               "", "3 0 1 2\n")}) {
        SCOPED_TRACE(text);
        const Mesh mesh = good(read_mesh(bytes_of(text), ""));
        EXPECT_NEAR(mesh.origin.x, 403210.051, 1e-6);
        EXPECT_NEAR(bounds(mesh).size().x, 0.1, 1e-6);
        EXPECT_NEAR(bounds(mesh).size().y, 0.05, 1e-6);
    }
    EXPECT_EQ(good(read_obj(bytes_of(square_obj("f 1 2 3")))).origin, Vec3d{});
}

TEST(ReadMesh, AnObjectNotFarFromZeroKeepsTheFloatsOfItsFile) {
    const auto square_at = [](double x) {
        std::string text;
        for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}})
            text += "v " + std::to_string(x + dx) + " " + std::to_string(dy) + " 0\n";
        return good(read_obj(bytes_of(text + "f 1 2 3\n"))).origin;
    };
    EXPECT_EQ(square_at(3.4), Vec3d{});  // the centre at 3.9 sides
    EXPECT_EQ(square_at(3.6), (Vec3d{4.1, 0.5, 0}));
}

TEST(ReadMesh, CoordinatesBeyondAllSizesAreRefused) {
    expect_holds(refused("v 0 0 0\nv 1e31 0 0\nv 0 1 0\nf 1 2 3\n"), "1e30");
    EXPECT_TRUE(read_obj(bytes_of("v 0 0 0\nv 1e29 0 0\nv 0 1 0\nf 1 2 3\n")).has_value());
}

TEST(ReadMesh, RandomMeshesComeBackFromEveryFormat) {
    for (int seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        // Every vertex is new and used in order, so that reading renumbers nothing.
        Mesh mesh;
        const auto count = static_cast<std::uint32_t>(random.integer(1, 50));
        for (std::uint32_t t = 0; t < count; ++t) {
            for (int corner = 0; corner < 3; ++corner)
                mesh.vertices.push_back(vec_cast<float>(
                    Vec3d{random.between(-90, 90), random.between(-1, 1), random.between(-1e-3, 100)}));
            mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        for (const FileBytes& file :
             {write_stl(mesh.vertices, mesh.triangles, "t"), write_ply(mesh.vertices, mesh.triangles, {}),
              write_ply(mesh.vertices, mesh.triangles, kLowerBlue), write_obj(mesh.vertices, mesh.triangles),
              write_off(mesh.vertices, mesh.triangles)}) {
            const Mesh read = good(read_mesh(file, ""));
            EXPECT_EQ(read.vertices, mesh.vertices);
            EXPECT_EQ(read.triangles, mesh.triangles);
        }
    }
}

TEST(ReadMesh, FilesCutAnywhereAndDamagedAnywhereNeverCrash) {
    const Mesh mesh = tetrahedron();
    const std::vector<FileBytes> files{
        write_stl(mesh.vertices, mesh.triangles, "t"), write_ply(mesh.vertices, mesh.triangles, kLowerBlue),
        write_obj(mesh.vertices, mesh.triangles), write_off(mesh.vertices, mesh.triangles)};
    const char* names[] = {"a.stl", "a.ply", "a.obj", "a.off"};
    Random random(7);
    for (std::size_t f = 0; f < files.size(); ++f) {
        for (std::size_t length = 0; length < files[f].size(); ++length) {
            const auto cut = read_mesh(std::span(files[f]).first(length), names[f]);
            ASSERT_TRUE(cut ? keeps_promises(*cut) : !snug::text(cut.error().message).empty());
        }
        for (int damage = 0; damage < 2000; ++damage) {
            FileBytes damaged = files[f];
            damaged[static_cast<std::size_t>(random.integer(0, static_cast<int>(damaged.size()) - 1))] =
                static_cast<std::byte>(random.integer(0, 255));
            const auto read = read_mesh(damaged, names[f]);
            ASSERT_TRUE(read ? keeps_promises(*read) : !snug::text(read.error().message).empty());
        }
    }
}

// Counted by a separate program: vertices that faces use, and corners less two of each face.
TEST(ReadMesh, SharedModelsHaveTheirVerticesAndTriangles) {
    struct Expected {
        const char* name;
        std::size_t vertices, triangles;
    };
    for (const auto& [name, vertices, triangles] :
         {Expected{"stanford-bunny.obj", 34834, 69451},  // and 1,113 vertices that no face uses
          {"armadillo.obj", 43243, 86482},
          {"spot.obj", 2930, 5856},
          {"teapot.obj", 3644, 6320},
          {"cow.obj", 2903, 5804},
          {"beetle-alt.obj", 19887, 38656},
          {"camelhead.off", 11381, 22704},
          {"screwdriver.off", 3395, 6786}}) {
        const auto file = test::model_file(name);
        if (!file) GTEST_SKIP() << "the shared models are not here";
        SCOPED_TRACE(name);
        const Mesh mesh = good(read_mesh(*file, name));
        EXPECT_TRUE(keeps_promises(mesh));
        EXPECT_EQ(mesh.vertices.size(), vertices);
        EXPECT_EQ(mesh.triangles.size(), triangles);
    }
}

}  // namespace
}  // namespace snug
