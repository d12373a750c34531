#include <string>

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

TEST(ReadOff, TheNumberOfEdgesMayBeMissingOrStandAnywhere) {
    const std::string rest = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const char* counts : {"OFF\n3 1 3\n", "OFF\n3 1\n", "OFF 3 1 0\n", "OFF 3 1\n", "OFF\n3\n1\n0\n",
                               "OFF\n3 1\n0\n", "OFF\n3 1 # no edges\n", "OFF\n3 1 999999999999\n"}) {
        SCOPED_TRACE(counts);
        const Mesh mesh = good(read_mesh(bytes_of(counts + rest), ""));
        EXPECT_DOUBLE_EQ(area(mesh), 0.5);
    }
}

TEST(ReadOff, EveryRelativeWithFurtherNumbersBehindTheVertex) {
    for (const char* word : {"COFF", "NOFF", "CNOFF", "STOFF", "STNOFF"}) {
        SCOPED_TRACE(word);
        const Mesh mesh = good(read_mesh(
            bytes_of(std::string(word) + "\n3 1 3\n0 0 0 1 2 3 4\n1 0 0 1 2 3 4\n0 1 0 1 2 3 4\n3 0 1 2 5\n"),
            ""));
        EXPECT_DOUBLE_EQ(area(mesh), 0.5);
    }
    expect_holds(refused("nOFF 3\n3 1 3\n"), "no kind of OFF");
    expect_holds(refused("OFF\n3 1 3\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), "line 4: a vertex needs three");
}

// 4294967299 and 4294967297 are 3 and 1 where sizes have 32 bits.
TEST(ReadOff, NumbersBeyond32BitsAreNotCutToSmallOnes) {
    expect_holds(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4294967299 0 1 2\n"), "is no number of corners");
    expect_holds(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 4294967297 2\n"), "is no vertex");
    expect_holds(refused("OFF\n4294967299 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                 "4,294,967,299 vertices are more than can be read");
}

}  // namespace
}  // namespace snug
