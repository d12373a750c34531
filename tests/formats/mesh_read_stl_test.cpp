#include <algorithm>
#include <cctype>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"

#include "tests/support/random.h"
#include "tests/support/read_checks.h"

namespace snug {
namespace {

using test::area;
using test::bytes_of;
using test::expect_holds;
using test::good;
using test::Random;
using test::refused;
using test::stl_of;
using test::tetrahedron;

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n";

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
    const std::string solid = "solid a b\n" + kFacet + "endsolid\n";
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
    expect_holds(refused(file.substr(0, 82), "a.stl"), "cut off");
}

TEST(ReadStl, BytesBehindTheTrianglesDoNotCountWhateverTheHeaderSays) {
    std::string file = stl_of(tetrahedron());
    std::memcpy(file.data(), "solid t", 8);
    for (const std::size_t more : {1u, 7u, 50u, 5000u}) {
        SCOPED_TRACE(more);
        EXPECT_EQ(good(read_mesh(bytes_of(file + std::string(more, 'x')), "a.stl")).triangles.size(), 4u);
    }
    expect_holds(refused(file.substr(0, 200), "a.stl"), "it says 4 triangles but holds 2");
}

TEST(ReadStl, EveryCutOfABinaryFileIsRefused) {
    for (const char* header : {"binary", "solid t"}) {
        std::string file = stl_of(tetrahedron());
        std::memcpy(file.data(), header, std::strlen(header) + 1);
        for (std::size_t length = 0; length < file.size(); ++length) {
            SCOPED_TRACE(length);
            EXPECT_FALSE(read_mesh(bytes_of(file).first(length), "a.stl").has_value());
        }
    }
}

TEST(ReadStl, FacetsWithCoordinatesThatAreNoNumberAreLeftOutUnlessTheyAreMostOfTheFile) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity(), 1e31f}) {
        std::string file = stl_of(tetrahedron());
        for (const int broken : {1, 2, 3}) {
            std::memcpy(file.data() + 84 + broken * 50 + 12 + 4, &bad, sizeof bad);
            if (broken == 3) break;
            const Mesh mesh = good(read_stl(bytes_of(file)));
            EXPECT_EQ(mesh.triangles.size(), 4u - static_cast<unsigned>(broken));
            EXPECT_EQ(mesh.read.left_out_faces, static_cast<std::size_t>(broken));
            EXPECT_EQ(mesh.read.faces, 4u);
        }
        expect_holds(refused(file), "3 of 4 faces");
    }
}

TEST(ReadStl, NoTrianglesAreNoObject) {
    expect_holds(refused(std::string(84, '\0'), "a.stl"), "no triangles");
    expect_holds(refused("solid a\nendsolid a\n"), "no triangles");
    expect_holds(refused("solid a\n", "a.stl"), "no triangles");
}

TEST(ReadStl, EveryCutOfAnAsciiFileBeforeTheEndOfItsSolidIsRefusedOrSaysSo) {
    const std::string whole = "solid a\n" + kFacet + kFacet + "endsolid a\n";
    for (std::size_t length = 0; length < whole.find("endsolid a") + 8; ++length) {
        SCOPED_TRACE(length);
        const auto mesh = read_mesh(bytes_of(whole).first(length), "a.stl");
        const bool within_facet =
            length < whole.find("endloop") + 7 ||
            (length > whole.find("endfacet") + 9 && length < whole.rfind("endloop") + 7);
        const bool whole_mesh = mesh && mesh->triangles.size() == 2;
        EXPECT_FALSE(whole_mesh && (within_facet || length <= 8));
        EXPECT_TRUE(!mesh || mesh->read.no_end);
    }
    EXPECT_EQ(good(read_stl(bytes_of(whole.substr(0, whole.find("endsolid a") + 8)))).triangles.size(), 2u);
    expect_holds(refused(whole.substr(0, whole.rfind("endloop"))), "line 14: the file is cut off within");
}

TEST(ReadStl, AnAsciiFileCutBetweenTwoFacetsOrSolidsIsReadAndSaysSo) {
    const std::string solid = "solid a\n" + kFacet + "endsolid a\n";
    for (const std::string& cut : {"solid a\n" + kFacet, "solid a\n" + kFacet + kFacet + "\n",
                                   solid + "solid b\n" + kFacet, solid + "solid b\n"}) {
        SCOPED_TRACE(cut);
        EXPECT_TRUE(good(read_mesh(bytes_of(cut), "")).read.no_end);
    }
    for (const std::string& whole : {solid, solid + solid, "solid a\n" + kFacet + solid})
        EXPECT_FALSE(good(read_stl(bytes_of(whole))).read.no_end) << whole;
    EXPECT_EQ(good(read_stl(bytes_of("solid a\n" + kFacet + solid))).triangles.size(), 2u);
}

TEST(ReadStl, AnAsciiFacetHasNoFourthVertexAndNothingElse) {
    const std::string start = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    expect_holds(refused(start + "vertex 0 1 0\nvertex 1 1 0\n"), "line 7: a facet has more than three");
    expect_holds(refused("solid a\nfacet normal 0 0 1\nouter loop\nnonsense\n"), "line 4: \"nonsense\"");
}

TEST(ReadStl, WeldingNumbersVerticesInTheOrderOfTheirFirstAppearance) {
    for (int seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        // Few places, so that most corners share theirs, or so many that hardly any do.
        const int places = seed % 2 == 0 ? 3 : 3000;
        Mesh soup;
        Mesh expected;
        for (std::uint32_t t = 0; t < 300; ++t) {
            Triangle triangle{};
            for (std::uint32_t& v : triangle) {
                const Vec3f p = vec_cast<float>(Vec3d{random.integer(-places, places) * 0.1,
                                                      random.integer(-places, places) * 1.0,
                                                      random.integer(0, 9) * 1e-30});
                soup.vertices.push_back(p);
                const auto known = std::find(expected.vertices.begin(), expected.vertices.end(), p);
                v = static_cast<std::uint32_t>(known - expected.vertices.begin());
                if (known == expected.vertices.end()) expected.vertices.push_back(p);
            }
            soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
            expected.triangles.push_back(triangle);
        }
        const Mesh mesh = good(read_stl(bytes_of(stl_of(soup))));
        EXPECT_EQ(mesh.vertices, expected.vertices);
        EXPECT_EQ(mesh.triangles, expected.triangles);
    }
}

}  // namespace
}  // namespace snug
