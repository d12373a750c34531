#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read_cloud.h"
#include "snug/words/words.h"

#include "tests/support/random.h"
#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::ascii_ply;
using test::bytes_of;
using test::expect_holds;
using test::good;

Mesh cloud_of(std::string_view text, std::string_view name = "a.xyz") {
    return good(read_mesh_or_cloud(bytes_of(text), name));
}

std::string refused_cloud(std::string_view text, std::string_view name = "a.xyz") {
    const auto cloud = read_mesh_or_cloud(bytes_of(text), name);
    EXPECT_FALSE(cloud.has_value()) << text;
    return cloud ? "" : snug::text(cloud.error().message);
}

const std::vector<Vec3f> kThree = {{1, 2, 3}, {-4, 5.5f, 6}, {7, 8, 90}};

TEST(ReadCloud, ColumnsStandApartByBlanksCommasOrSemicolons) {
    for (const char* text :
         {"1 2 3\n-4 5.5 6\n7 8 9e1\n", "1\t2\t3\r\n-4 \t 5.5 6\r\n+7 8 90", "1,2,3\n-4, 5.5 ,6\n7,8,90\n",
          "1;2;3\n-4; 5.5;6\n7;8;90;", "\n# c\n1 2 3 # d\n// e\n  -4 5.5 6 0.5 255 0 0\n\n7 8 90\n",
          "//X Y Z\n1 2 3\n-4 5.5 6\n7 8 90", "X,Y,Z,R\n1,2,3,4\n-4,5.5,6,4\n7,8,90,4\n",
          "\xEF\xBB\xBF"
          "3\n1 2 3 -900 1 2 3\n-4 5.5 6 7 7 7 7\n7 8 90 1 1 1 1\n",
          "1\n1 2 3\n2\r-4 5.5 6\r7 8 90\r", "0\n1 2 3\n-4 5.5 6\n7 8 90 nan"}) {
        SCOPED_TRACE(text);
        const Mesh cloud = cloud_of(text, "a.PTS");
        EXPECT_TRUE(cloud.is_cloud());
        EXPECT_EQ(cloud.vertices, kThree);
    }
}

TEST(ReadCloud, SaysWhatIsWrong) {
    expect_holds(refused_cloud("1 2 3\n1,5 2,5 3,5\n"), "line 2: commas");
    expect_holds(refused_cloud("1,5;2,5;3,5\n"), "decimal commas");
    expect_holds(refused_cloud("1 2\n"), "line 1: a point needs three numbers x y z, and here are only 2");
    expect_holds(refused_cloud("1 2 3\n\n1 2 z\n"), "line 3: a point needs three numbers x y z, not \"z\"");
    expect_holds(refused_cloud("1 2 inf\n"), "1 of 1 points have a coordinate that is not a number");
    expect_holds(refused_cloud("nan 2 3\n1 nan 3\n4 5 6"), "2 of 3 points");
    expect_holds(refused_cloud("1 2 1e31\n"), "beyond 1e30");
    expect_holds(refused_cloud("1 2 3..4\n"), "not \"3..4\"");
    expect_holds(refused_cloud("3\n1 2 3\n4 5 6\n"), "promises 3 points and has 2");
    expect_holds(refused_cloud("18446744073709551615\n1 2 3\n"), "line 1: ");
    expect_holds(refused_cloud("9223372036854775807\n1 2 3\n"), "too short");
    expect_holds(refused_cloud("# nothing\n"), "no points");
    expect_holds(refused_cloud(std::string(100000, '9')), "three numbers");
    expect_holds(refused_cloud(""), "empty");
    expect_holds(refused_cloud("1 2 3\n", "a.stl"), "");
}

TEST(ReadCloud, APlyWithoutTrianglesIsACloudOfItsVertices) {
    const std::string points = "1 2 3\n-4 5.5 6\n7 8 90\n";
    EXPECT_EQ(cloud_of(ascii_ply(3, 0, points), "").vertices, kThree);
    std::string without_faces = ascii_ply(3, 0, points);
    const std::size_t begin = without_faces.find("element face");
    without_faces.erase(begin, without_faces.find("end_header") - begin);
    EXPECT_EQ(cloud_of(without_faces, "").vertices, kThree);
    EXPECT_FALSE(cloud_of(ascii_ply(3, 1, points + "3 0 1 2\n"), "").is_cloud());
    expect_holds(refused_cloud(ascii_ply(0, 0, ""), ""), "no points");
    expect_holds(test::refused(ascii_ply(3, 0, points)), "point cloud");
}

TEST(ReadCloud, SurveyCoordinatesKeepTheirMillimetres) {
    const Mesh cloud = cloud_of("512345678.125 -7234567.25 100\n512345679.625 -7234566.75 101.5\n");
    ASSERT_EQ(cloud.vertices.size(), 2u);
    for (const int i : {0, 1}) {
        const Vec3d p = vec_cast<double>(cloud.vertices[static_cast<std::size_t>(i)]) + cloud.origin;
        EXPECT_EQ(p, i == 0 ? Vec3d(Vec3d{512345678.125, -7234567.25, 100})
                            : Vec3d(Vec3d{512345679.625, -7234566.75, 101.5}));
    }
}

TEST(ReadCloud, DamagedTextGivesACloudOrASentence) {
    const std::string text = "4\n1.5 -2e1 3 7\n// c\n4,5,6\n7;8;9\n10\t11 12 0.5 1 1\n";
    const std::string bytes = std::string(" ,;#/\n\r9e.-+x") + '\0' + '\xff';
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        std::string damaged = text.substr(0, static_cast<std::size_t>(random.integer(0, 60)));
        for (int change = random.integer(0, 4); change > 0 && !damaged.empty(); --change)
            damaged[random.bits() % damaged.size()] = bytes[random.bits() % bytes.size()];
        const auto cloud = read_xyz(bytes_of(damaged));
        if (!cloud) {
            EXPECT_FALSE(snug::text(cloud.error().message).empty());
            continue;
        }
        EXPECT_TRUE(cloud->is_cloud());
        for (const Vec3f& p : cloud->vertices) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
}

}  // namespace
}  // namespace snug
