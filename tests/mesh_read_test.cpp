#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/mesh_files.h"
#include "snug/mesh/raw_mesh.h"
#include "snug/mesh/read.h"

#include "tests/support/models.h"
#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

Bytes bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

Mesh good(const Result<Mesh>& mesh) {
    EXPECT_TRUE(mesh.has_value()) << mesh.error().message;
    return mesh.value_or(Mesh{});
}

/// The sentence of a refused file, to be searched for words.
std::string refused(std::string_view text, std::string_view name = "") {
    const auto mesh = read_mesh(bytes_of(text), name);
    EXPECT_FALSE(mesh.has_value());
    return mesh ? "" : mesh.error().message;
}

void expect_holds(const std::string& sentence, const char* words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
}

constexpr std::string_view kObjSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string obj(std::string_view rest) {
    return std::string(kObjSquare) + std::string(rest);
}

/// The area that the triangles cover, with the way they are wound.
double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3f p = mesh.vertices[a], q = mesh.vertices[b], r = mesh.vertices[c];
        sum += 0.5 * static_cast<double>((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
    }
    return sum;
}

// ---- OBJ

TEST(ReadObj, PolygonsOfAnyKindOfIndex) {
    for (const char* face :
         {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1/1 2/1 3/1 4/1", "f 1//1 2//1 3//1 4//1",
          "f 1/1/1 2/1/1 3/1/1 4/1/1", "f 1 2 \\\n 3 4", "f 1 2\\\n 3 4\r\n", "f +1 +2 +3 +4",
          "\tf  1 2 3 4 # four", "g a b\no c\nusemtl d\ns 1\nf 1 2 3 4\nl 1 2\np 1"}) {
        SCOPED_TRACE(face);
        const Mesh mesh = good(read_obj(bytes_of(obj(face))));
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
    expect_holds(refused(obj("f 1 2 9\n")), "line 5: the face wants vertex 9");
    expect_holds(refused(obj("f 0 1 2\n")), "line 5: \"0\" is no vertex number");
    expect_holds(refused(obj("f -5 -1 -2\n")), "line 5");
    expect_holds(refused(obj("f 1 2\n")), "line 5: a face has only 2 corners");
    expect_holds(refused(obj("f 1 x 3\n")), "\"x\"");
    expect_holds(refused("v 0 0\nf 1 1 1\n"), "line 1: a vertex needs three numbers");
    expect_holds(refused("v 0 0 nan\nf 1 1 1\n"), "line 1");
    expect_holds(refused("v 0 0 1e400\nf 1 1 1\n"), "line 1");
    expect_holds(refused(kObjSquare), "point cloud");
    expect_holds(refused("# nothing\n", "a.obj"), "no triangles");
}

// ---- STL

std::string stl_of(const Mesh& mesh) {
    const FileBytes file = write_stl(mesh.vertices, mesh.triangles, "t");
    return {reinterpret_cast<const char*>(file.data()), file.size()};
}

Mesh tetrahedron() {
    return {
        {{0, 0, 0}, {60, 0, 0}, {0, 60, 0}, {0, 0, 60}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, {}};
}

TEST(ReadStl, WeldsByBitsWithBothZerosEqual) {
    Mesh soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, -0.0f}, {0, 1, 0}, {0, 0, 1}},
              {{0, 1, 2}, {3, 4, 5}},
              {}};
    const Mesh mesh = good(read_stl(bytes_of(stl_of(soup))));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadStl, BinaryThatSaysSolidIsStillBinary) {
    std::string file = stl_of(tetrahedron());
    std::memcpy(file.data(), "solid tetrahedron\nfacet", 23);
    EXPECT_EQ(good(read_mesh(bytes_of(file), "a.stl")).triangles.size(), 4u);
}

TEST(ReadStl, AsciiOfSeveralSolidsInAnyCase) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n";
    const std::string solid = "solid a b\n" + facet + "endsolid\n";
    EXPECT_EQ(good(read_mesh(bytes_of(solid + solid), "")).triangles.size(), 2u);
    std::string upper = solid;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return static_cast<char>(std::toupper(c)); });
    EXPECT_EQ(good(read_mesh(bytes_of(upper), "")).triangles.size(), 1u);
    std::string carriage;
    for (const char c : solid) carriage += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(good(read_mesh(bytes_of(carriage), "")).triangles.size(), 1u);
    expect_holds(refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n"), "line 4");
    expect_holds(refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"), "cut off");
}

TEST(ReadStl, ACutOffFileSaysHowFarItGoes) {
    std::string file = stl_of(tetrahedron());
    file.resize(file.size() - 60);
    expect_holds(refused(file, "a.stl"), "it says 4 triangles but holds 2");
    expect_holds(refused(file.substr(0, 30), "a.stl"), "cut off");
}

// ---- PLY

TEST(ReadPly, SkipsWhatItDoesNotNeedInAnyOrder) {
    const Mesh mesh = good(read_ply(
        bytes_of("ply\r\nformat ascii 1.0\r\ncomment c\r\nobj_info o\r\nelement other 2\r\nproperty list "
                 "uchar float things\r\n"
                 "property short n\r\nelement face 1\r\nproperty int flags\r\nproperty list uint8 uint32 "
                 "vertex_index\r\n"
                 "element vertex 4\r\nproperty float z\r\nproperty uchar red\r\nproperty double "
                 "y\r\nproperty int x\r\nend_header\r\n"
                 "2 1.5 2.5 7\r\n0 8\r\n5 4 0 1 2 3\r\n0 1 0 0\r\n0 1 0 1\r\n0 1 1 1\r\n0 1 1 0\r\n")));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_DOUBLE_EQ(area(mesh), 1);
}

TEST(ReadPly, StripsTurnEverySecondTriangleAndStartAgain) {
    const Mesh mesh = good(read_ply(bytes_of(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n13\n0 1 2 3 -1 2 3 4 5 -1 0 0 1\n")));
    EXPECT_EQ(mesh.triangles.size(), 4u);
    EXPECT_DOUBLE_EQ(area(mesh), 2);
}

TEST(ReadPly, LyingAndDamagedFilesAreRefusedQuickly) {
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float "
        "y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    expect_holds(refused(header), "4,000,000,000");
    expect_holds(refused("ply\nformat ascii 1.0\nelement vertex 3\n"), "end_header");
    expect_holds(refused("ply\nformat cuneiform 1.0\nend_header\n"), "line 2");
    expect_holds(refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                         "property float z\nend_header\n0 0 0\n"),
                 "point cloud");
    expect_holds(
        refused(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 "
            "7\n"),
        "vertex 7");
}

// ---- OFF

TEST(ReadOff, RelativesCommentsAndColours) {
    const Mesh mesh =
        good(read_mesh(bytes_of("# c\nCOFF # d\n4 1 0\n\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n# e\n1 1 0 1 0 0 1\n"
                                "0 1 0 1 0 0 1\n4 0 1 2 3 0.5 0.5 0.5\n"),
                       ""));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_DOUBLE_EQ(area(mesh), 1);
    EXPECT_EQ(good(read_off(bytes_of("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2"))).triangles.size(), 1u);
}

TEST(ReadOff, SaysWhatIsWrong) {
    expect_holds(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6: \"3\" is no vertex");
    expect_holds(refused("OFF\n4000000000 1 0\n0 0 0\n"), "too short");
    expect_holds(refused("OFF\n30 1 0\n0 0 0\n1 0 0\n0 0 0 0 0 0 0 0 0 0 0 0 0\n"), "cut off");
    expect_holds(refused("OFF BINARY\n"), "binary");
    expect_holds(refused("4OFF\n1 1 1\n"), "no kind of OFF");
}

// ---- all of them

TEST(ReadMesh, TheContentTellsTheFormatBeforeTheName) {
    EXPECT_EQ(read_mesh(bytes_of(obj("f 1 2 3")), "a.stl").value().triangles.size(), 1u);
    EXPECT_EQ(mesh_format(bytes_of(stl_of(tetrahedron())), "a.obj").value(), MeshFormat::stl);
    EXPECT_EQ(mesh_format(bytes_of("ply\nwhatever"), "a.off").value(), MeshFormat::ply);
    EXPECT_EQ(mesh_format(bytes_of("whatever"), "A.OFF").value(), MeshFormat::off);
}

TEST(ReadMesh, OtherFormatsAreNamedWithWhatToDo) {
    expect_holds(refused(""), "empty");
    expect_holds(refused("PK\x03\x04..."), "3MF");
    expect_holds(refused("glTF\x02"), "glTF");
    expect_holds(refused("ISO-10303-21;"), "STEP");
    expect_holds(refused("Dear diary,", "diary.txt"), "STL, OBJ, PLY and OFF");
}

TEST(ReadMesh, UnusedVerticesDoNotCount) {
    const Mesh mesh = good(read_obj(bytes_of("v 999 999 999\n" + obj("f 2 3 4\nv 5 5 5\n"))));
    EXPECT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ReadMesh, SurveyCoordinatesKeepTheirDetail) {
    const Mesh mesh =
        good(read_obj(bytes_of("v 403210.001 3204000.002 100.003\nv 403210.101 3204000.002 100.003\n"
                               "v 403210.001 3204000.052 100.003\nf 1 2 3\n")));
    EXPECT_NEAR(mesh.origin.x, 403210.051, 1e-6);
    EXPECT_NEAR(bounds(mesh).size().x, 0.1, 1e-6);
    EXPECT_NEAR(bounds(mesh).size().y, 0.05, 1e-6);
    EXPECT_EQ(good(read_obj(bytes_of(obj("f 1 2 3")))).origin, Vec3d{});
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
            ASSERT_TRUE(cut || !cut.error().message.empty());
        }
        for (int damage = 0; damage < 2000; ++damage) {
            FileBytes damaged = files[f];
            damaged[static_cast<std::size_t>(random.integer(0, static_cast<int>(damaged.size()) - 1))] =
                static_cast<std::byte>(random.integer(0, 255));
            const auto read = read_mesh(damaged, names[f]);
            ASSERT_TRUE(read || !read.error().message.empty());
        }
    }
}

TEST(ReadMesh, BigEndianIsTheMirrorOfLittleEndian) {
    const std::string header =
        "element vertex 3\nproperty double x\nproperty float y\nproperty short z\nelement face 1\n"
        "property list ushort uint vertex_indices\nend_header\n";
    const auto file = [&](bool big) {
        std::string data =
            std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + header;
        const auto put = [&](auto value) {
            char raw[sizeof value];
            std::memcpy(raw, &value, sizeof value);
            if (big) std::reverse(raw, raw + sizeof value);
            data.append(raw, sizeof value);
        };
        for (int v = 0; v < 3; ++v)
            put(v == 1 ? 2.5 : 0.0), put(v == 2 ? 3.5f : 0.0f), put(static_cast<short>(-7 * v));
        put(static_cast<unsigned short>(3));
        for (unsigned v = 0; v < 3; ++v) put(v);
        return data;
    };
    const Mesh little = good(read_ply(bytes_of(file(false)))), big = good(read_ply(bytes_of(file(true))));
    EXPECT_EQ(little.vertices, (std::vector<Vec3f>{{0, 0, 0}, {2.5, 0, -7}, {0, 3.5, -14}}));
    EXPECT_EQ(little.vertices, big.vertices);
    EXPECT_EQ(little.triangles, big.triangles);
}

TEST(ReadMesh, PolygonsOfAnyShapeKeepTheirArea) {
    for (int seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        // A star-shaped polygon in a tilted plane.
        RawMesh raw;
        std::vector<std::uint32_t> corners;
        const int n = random.integer(4, 40);
        double expected = 0;
        std::vector<Vec3d> flat;
        for (int i = 0; i < n; ++i) {
            const double angle = 6.283185307179586 * (i + random.between(0, 0.8)) / n,
                         radius = random.between(0.2, 1);
            flat.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
            corners.push_back(static_cast<std::uint32_t>(i));
        }
        for (int i = 0; i < n; ++i) {
            const Vec3d p = flat[static_cast<std::size_t>(i)],
                        q = flat[static_cast<std::size_t>((i + 1) % n)];
            expected += 0.5 * (p.x * q.y - p.y * q.x);
            raw.vertices.push_back({p.x + 0.3 * p.y, p.y, p.x - p.y});
        }
        append_polygon(raw, corners);
        ASSERT_EQ(raw.triangles.size(), corners.size() - 2);
        double covered = 0;
        for (const auto& [a, b, c] : raw.triangles) {
            const Vec3d normal = cross(raw.vertices[b] - raw.vertices[a], raw.vertices[c] - raw.vertices[a]);
            EXPECT_GE(normal.z, -1e-12);
            covered += 0.5 * normal.z;
        }
        EXPECT_NEAR(covered, expected, 1e-9);
    }
}

TEST(ReadMesh, SharedModelsHaveTheirVerticesAndTriangles) {
    struct Expected {
        const char* name;
        std::size_t vertices;
    };
    for (const auto& [name, vertices] : {Expected{"stanford-bunny.obj", 35947},
                                         {"armadillo.obj", 43243},
                                         {"spot.obj", 2930},
                                         {"teapot.obj", 3644},
                                         {"cow.obj", 2903},
                                         {"beetle-alt.obj", 19887},
                                         {"camelhead.off", 11381},
                                         {"screwdriver.off", 3395}}) {
        const auto file = test::model_file(name);
        if (!file) GTEST_SKIP() << "the shared models are not here";
        const Mesh mesh = good(read_mesh(*file, name));
        // Of the vertices in the file only those that faces use count.
        std::set<std::uint32_t> used;
        for (const Triangle& t : mesh.triangles) used.insert(t.begin(), t.end());
        EXPECT_EQ(used.size(), mesh.vertices.size()) << name;
        EXPECT_LE(mesh.vertices.size(), vertices) << name;
        EXPECT_GE(mesh.vertices.size(), vertices * 9 / 10) << name;
    }
}

}  // namespace
}  // namespace snug
