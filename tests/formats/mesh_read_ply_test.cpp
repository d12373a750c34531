#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"

#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::area;
using test::ascii_ply;
using test::bytes_of;
using test::expect_holds;
using test::good;
using test::refused;

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
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")), "vertex 7");
}

TEST(ReadPly, BigEndianIsTheMirrorOfLittleEndian) {
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

TEST(ReadPly, SaysWhichElementIsWrong) {
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 one 0\n0 1 0\n3 0 1 2\n")),
                 "line 11: \"one\" is no number that can stand in \"vertex\" 2 of 3");
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1")), "cut off or damaged at \"vertex\" 3 of 3");
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")), "face 1 wants vertex 3");
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n")), "face 1 wants vertex -1");
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n")), "line 13: \"1.5\"");
    expect_holds(refused(ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")), "line 13: \"-3\"");
    expect_holds(refused("plx" + ascii_ply(3, 1, "").substr(3), "a.ply"), "line 1: \"plx\" is no PLY file");
}

TEST(ReadPly, FacesOfFewerThanThreeCornersAreNoSurface) {
    const Mesh mesh =
        good(read_ply(bytes_of(ascii_ply(3, 4, "0 0 0\n1 0 0\n0 1 0\n2 0 1\n0\n3 0 1 2\n3 2 1 0\n"))));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}}));
}

TEST(ReadPly, ElementsWithoutPropertiesTakeNoTimeHoweverMany) {
    std::string file = ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    file.insert(file.find("element vertex"), "element nothing 4000000000\n");
    EXPECT_EQ(good(read_ply(bytes_of(file))).triangles.size(), 1u);
}

TEST(ReadPly, DataBehindAHeaderWithLoneCarriageReturnsMayBeginWithALineFeed) {
    std::string file =
        "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty char x\rproperty char y\r"
        "property char z\relement face 1\rproperty list uchar uchar vertex_indices\rend_header\r";
    file += std::string("\n\0\0\1\0\0\0\1\0\3\0\1\2", 13);
    const Mesh mesh = good(read_mesh(bytes_of(file), ""));
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_FLOAT_EQ(mesh.vertices[0].x, 10);
}

TEST(ReadPly, AByteOrderMarkOrABlankBehindTheFirstWordIsNoHindrance) {
    const std::string file = ascii_ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_EQ(good(read_mesh(bytes_of("\xef\xbb\xbf" + file), "")).triangles.size(), 1u);
    EXPECT_EQ(good(read_mesh(bytes_of("ply \n" + file.substr(4)), "")).triangles.size(), 1u);
}

TEST(ReadPly, FacesBeforeAndBehindTheirVerticesKeepTheOrderOfTheFile) {
    const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string vertices = "\nproperty float x\nproperty float y\nproperty float z\n";
    const auto file = [&](std::string_view first_face) {
        return "ply\nformat ascii 1.0\n" + faces + "element vertex 4" + vertices + faces +
               "element vertex 1" + vertices + faces + "end_header\n" + std::string(first_face) +
               "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 2 3 4\n9 9 9\n3 1 2 3\n";
    };
    const Mesh mesh = good(read_ply(bytes_of(file("4 0 1 2 3\n"))));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {2, 3, 4}, {1, 2, 3}}));
    expect_holds(refused(file("3 0 1 5\n")), "face 1 wants vertex 5, but there are 5 vertices");
    expect_holds(refused(file("3 0 1 x\n")), "line 18: \"x\" is no number that can stand in \"face\" 1 of 1");
}

TEST(ReadPly, ACutOffFileSaysSoBeforeItBlamesAnIndex) {
    expect_holds(refused(ascii_ply(3, 2, "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n3 0 1")), "\"face\" 2 of 2");
    expect_holds(refused(ascii_ply(3, 2, "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n3 0 1 8\n")),
                 "face 1 wants vertex 7");
}

// 4294967299 and 4294967297 are 3 and 1 where sizes have 32 bits.
TEST(ReadPly, NumbersBeyond32BitsAreNotCutToSmallOnes) {
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
    expect_holds(refused(ascii_ply(3, 1, vertices + "4294967299 0 1 2\n")), "line 13: \"4294967299\"");
    expect_holds(refused(ascii_ply(3, 1, vertices + "3 0 4294967297 2\n")), "wants vertex 4294967297");
    std::string lying = ascii_ply(3, 1, vertices + "3 0 1 2\n");
    lying.replace(lying.find("vertex 3"), 8, "vertex 4294967299");
    expect_holds(refused(lying), "it says 4,294,967,299 of \"vertex\"");
}

}  // namespace
}  // namespace snug
