#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "snug/drawing/svg.h"
#include "snug/picture/depth_image.h"
#include "snug/picture/isometric.h"
#include "snug/picture/object_outlines.h"
#include "snug/picture/outline.h"
#include "snug/picture/relief.h"
#include "snug/space/available.h"

#include "tests/support/heights.h"
#include "tests/support/random.h"
#include "tests/support/random_available.h"

// The pieces that the preview is drawn with: projection, relief, images, outlines, text.

namespace snug {
namespace {

using test::Random;

Vec3d random_point(Random& random) {
    return {random.between(-100, 100), random.between(-100, 100), random.between(-100, 100)};
}

Grid<std::uint16_t> grid(std::vector<std::vector<int>> rows) {
    Grid<std::uint16_t> result(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()));
    for (int j = 0; j < result.ny(); ++j)
        for (int k = 0; k < result.nz(); ++k) result(j, k) = static_cast<std::uint16_t>(rows[j][k]);
    return result;
}

Mask mask(std::vector<std::string> rows) {
    Mask result(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
    for (int row = 0; row < result.height; ++row)
        for (int column = 0; column < result.width; ++column)
            if (rows[row][column] == '#') result.set(column, row);
    return result;
}

TEST(Isometric, LowerHasXUpYTowardsTheViewerAndZToTheRight) {
    const OpenedPair pair = opened({{10, 8, 6}, {5, 5, 5}}, 4);
    const Projected origin = project(pair.lower({0, 0, 0}));
    EXPECT_LT(project(pair.lower({1, 0, 0})).at.y, origin.at.y);
    EXPECT_NEAR(project(pair.lower({1, 0, 0})).at.x, origin.at.x, 1e-12);
    EXPECT_GT(project(pair.lower({0, 1, 0})).at.y, origin.at.y);
    EXPECT_GT(project(pair.lower({0, 1, 0})).nearness, origin.nearness);
    EXPECT_GT(project(pair.lower({0, 0, 1})).at.x, origin.at.x);
}

TEST(Isometric, LidHasItsCavityUpYAwayFromTheViewerAndZToTheRight) {
    const OpenedPair pair = opened({{10, 8, 6}, {5, 5, 5}}, 4);
    const Projected origin = project(pair.lid({0, 0, 0}));
    EXPECT_LT(project(pair.lid({-1, 0, 0})).at.y, origin.at.y);
    EXPECT_LT(project(pair.lid({0, 1, 0})).at.y, origin.at.y);
    EXPECT_LT(project(pair.lid({0, 1, 0})).nearness, origin.nearness);
    EXPECT_GT(project(pair.lid({0, 0, 1})).at.x, origin.at.x);
}

TEST(Isometric, OpeningTurnsTheLidByHalfATurnAboutTheHinge) {
    const DesignSpace space{{10, 8, 6}, {5, 7, 9}};
    const OpenedPair pair = opened(space, 4);
    const Vec3d hinge{space.face(0, 4), space.face(1, 0), 0};
    EXPECT_NEAR(pair.lower(hinge).y, -pair.lid(hinge).y, 1e-12);
    EXPECT_GT(pair.half_gap, 0);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Vec3d p = random_point(random);
        const Vec3d lower = pair.lower(p), lid = pair.lid(p);
        EXPECT_NEAR(lid.x, lower.x, 1e-12);  // along the hinge nothing moves, so nothing is mirrored
        EXPECT_NEAR(lid.y, -lower.y, 1e-12);
        EXPECT_NEAR(lid.z, -lower.z, 1e-12);
    }
}

TEST(Isometric, ProjectionKeepsLengths) {
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        const Vec3d p = random_point(random);
        const Projected seen = project(p);
        EXPECT_NEAR(seen.at.x * seen.at.x + seen.at.y * seen.at.y + seen.nearness * seen.nearness, dot(p, p),
                    1e-9);
    }
}

const DesignSpace kSpaceOfL{{8, 4, 5}, {10, 10, 10}};
// An L: its long leg along z, its foot towards +y at the leg's +z end.
const Foams kL =
    test::foams_of_heights(grid({{5, 5, 5, 5, 5}, {5, 2, 2, 2, 5}, {5, 5, 5, 2, 5}, {5, 5, 5, 5, 5}}),
                           grid({{3, 3, 3, 3, 3}, {3, 1, 1, 1, 3}, {3, 3, 3, 1, 3}, {3, 3, 3, 3, 3}}), 5, 8);

TEST(Relief, AnLIsSeenUnmirroredInTheLowerHalfAndTurnedOverInTheLid) {
    const OpenedPair pair = opened(kSpaceOfL, kL.parting.front());
    const Relief lower = relief(kL, kSpaceOfL, pair, Half::lower);
    const Relief lid = relief(kL, kSpaceOfL, pair, Half::lid);
    // Rows from the back to the viewer, columns to the right, as on the page.
    const int lower_rows[4][5] = {{5, 5, 5, 5, 5}, {5, 2, 2, 2, 5}, {5, 5, 5, 2, 5}, {5, 5, 5, 5, 5}};
    const int lid_rows[4][5] = {{3, 3, 3, 3, 3}, {3, 3, 3, 1, 3}, {3, 1, 1, 1, 3}, {3, 3, 3, 3, 3}};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 5; ++column) {
            EXPECT_EQ(lower.layers(row, column), lower_rows[row][column]) << row << " " << column;
            EXPECT_EQ(lid.layers(row, column), lid_rows[row][column]) << row << " " << column;
        }
    EXPECT_LT(lid.front_faces.back(), lower.front_faces.front());  // the lid lies behind
    EXPECT_TRUE(std::is_sorted(lid.front_faces.begin(), lid.front_faces.end()));
    EXPECT_NEAR(lower.height(0, 0), 0, 1e-12);  // both rims lie at the hinge's height
    EXPECT_NEAR(lid.height(0, 0), 0, 1e-12);
}

TEST(Relief, ManyColumnsAreDrawnTogetherAndNoCavityIsLost) {
    const DesignSpace space{{9, 3, 500}, {1, 1, 1}};
    test::Heights heights = test::filled(3, 500, 9);
    heights(1, 333) = 4;
    const Foams foams = test::foams_of_heights(heights, test::filled(3, 500, 0), 9, 9);
    const Relief lower = relief(foams, space, opened(space, 9), Half::lower);
    EXPECT_LE(lower.layers.nz(), 120);
    EXPECT_GT(lower.blocks_per_cell, 1);
    EXPECT_EQ(*std::min_element(lower.layers.begin(), lower.layers.end()), 4);
    EXPECT_NEAR(lower.right_faces.front(), -250, 1e-9);
    EXPECT_NEAR(lower.right_faces.back(), 250, 1e-9);
    EXPECT_TRUE(std::is_sorted(lower.right_faces.begin(), lower.right_faces.end()));
}

struct RandomRelief {
    DesignSpace space;
    Foams foams;
    explicit RandomRelief(Random& random) {
        space.blocks = {random.integer(1, 6), random.integer(1, 7), random.integer(1, 7)};
        space.block_mm = {random.between(1, 9), random.between(1, 9), random.between(1, 9)};
        const int nx = space.blocks.x, parting = random.integer(0, nx);
        test::Heights lower(space.blocks.y, space.blocks.z), upper = lower;
        for (std::size_t i = 0; i < lower.size(); ++i) {
            lower[i] = static_cast<std::uint16_t>(random.integer(0, nx));
            upper[i] = static_cast<std::uint16_t>(random.integer(0, nx - lower[i]));
        }
        foams = test::foams_of_heights(lower, upper, parting, nx);
        if (random.chance(0.5)) test::shorten(foams, test::random_available(random, space.blocks));
    }
};

/// Levels of one run that the other does not have.
int without(Run run, Run other) {
    return run.blocks() - std::max(0, run.common(other).blocks());
}

double cross_length(Vec3d a, Vec3d b) {
    const Vec3d c = cross(a, b);
    return std::sqrt(dot(c, c));
}

TEST(Relief, FacesHaveTheAreaThatTheColumnsExpose) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const RandomRelief given(random);
        const Vec3d mm = given.space.block_mm;
        const Grid<snug::Run> kept = kept_runs(given.foams, Half::lower, given.space.blocks.x);
        const auto run = [&](int j, int k) { return kept.contains(j, k) ? kept(j, k) : snug::Run{}; };
        double expected[3] = {0, 0, 0}, found[3] = {0, 0, 0};
        for (int j = 0; j < kept.ny(); ++j)
            for (int k = 0; k < kept.nz(); ++k) {
                expected[0] += run(j, k).none() ? 0 : mm.y * mm.z;
                expected[1] += without(run(j, k), run(j + 1, k)) * mm.x * mm.z;
                expected[2] += without(run(j, k), run(j, k + 1)) * mm.x * mm.y;
            }
        const OpenedPair pair = opened(given.space, given.foams.parting.front());
        for (const Face& face : visible_faces(relief(given.foams, given.space, pair, Half::lower)))
            found[static_cast<int>(face.side)] += cross_length(face.across, face.along);
        for (int side = 0; side < 3; ++side) EXPECT_NEAR(found[side], expected[side], 1e-6) << side;
    }
}

TEST(Relief, WhatIsDrawnLastIsNearestToTheViewer) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const RandomRelief given(random);
        const OpenedPair pair = opened(given.space, given.foams.parting.front());
        const Half half = random.chance(0.5) ? Half::lower : Half::lid;
        const std::vector<Face> faces = visible_faces(relief(given.foams, given.space, pair, half));
        const ImageFrame frame{{-150, -150}, 1.5, 200, 200};
        DepthImage nearest(frame);
        std::vector<double> painted(200 * 200, -INFINITY);
        for (const Face& face : faces) {
            DepthImage alone(frame);
            const Projected a = project(face.origin), b = project(face.origin + face.across),
                            c = project(face.origin + face.across + face.along),
                            d = project(face.origin + face.along);
            for (DepthImage* image : {&alone, &nearest}) {
                image->draw(a, b, c, false);
                image->draw(a, c, d, false);
            }
            for (int row = 0; row < 200; ++row)
                for (int column = 0; column < 200; ++column)
                    if (alone.covered(column, row)) painted[row * 200 + column] = alone.nearness(column, row);
        }
        for (int row = 0; row < 200; ++row)
            for (int column = 0; column < 200; ++column)
                if (nearest.covered(column, row)) {
                    ASSERT_NEAR(painted[row * 200 + column], nearest.nearness(column, row), 1e-6);
                }
    }
}

TEST(DepthImage, KeepsTheNearestWhateverTheOrder) {
    const ImageFrame frame{{0, 0}, 1, 20, 20};
    Random random(3);
    std::vector<Projected> corners;
    for (int i = 0; i < 60; ++i)
        corners.push_back({{random.between(-5, 25), random.between(-5, 25)}, random.between(-9, 9)});
    DepthImage forth(frame), back(frame);
    for (int i = 0; i < 60; i += 3) {
        forth.draw(corners[i], corners[i + 1], corners[i + 2], true);
        const int j = 57 - i;
        back.draw(corners[j], corners[j + 1], corners[j + 2], true);
    }
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column)
            EXPECT_EQ(forth.nearness(column, row), back.nearness(column, row));
}

TEST(DepthImage, TrianglesSeenEdgeOnStillCoverTheirLine) {
    DepthImage image({{0, 0}, 1, 10, 10});
    image.draw({{1.5, 5.5}, 0}, {{8.5, 5.5}, 1}, {{4, 5.5}, 0.5}, true);
    for (int column = 1; column <= 8; ++column) EXPECT_TRUE(image.covered(column, 5)) << column;
    EXPECT_FALSE(image.covered(4, 4));
}

TEST(Outline, ASquareGivesItsBorderWithinACell) {
    Mask square(40, 40);
    for (int row = 10; row < 30; ++row)
        for (int column = 5; column < 35; ++column) square.set(column, row);
    const std::vector<Loop> loops = outlines(square, 4);
    ASSERT_EQ(loops.size(), 1u);
    const Loop loop = simplified(loops[0], 0.5);
    EXPECT_NEAR(signed_area(loop), 600, 15);
    EXPECT_LE(loop.size(), 12u);
    for (const Vec2d p : loop) {
        const double aside = std::min(std::fabs(p.x - 5), std::fabs(p.x - 35));
        const double above = std::min(std::fabs(p.y - 10), std::fabs(p.y - 30));
        EXPECT_LE(std::min(aside, above), 1.0);
    }
}

TEST(Outline, ARingHasAHoleThatRunsTheOtherWay) {
    Mask ring(60, 60);
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column) {
            const double x = column - 29.5, y = row - 29.5, r = std::sqrt(x * x + y * y);
            if (r < 25 && r > 12) ring.set(column, row);
        }
    std::vector<Loop> loops = outlines(ring, 4);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_NEAR(signed_area(loops[0]), 3.14159 * 625, 25);
    EXPECT_NEAR(signed_area(loops[1]), -3.14159 * 144, 15);
}

TEST(Outline, CellsThatMeetInACornerAreOneLoop) {
    EXPECT_EQ(outlines(mask({"#...", ".#..", "..#.", "...#"}), 0).size(), 1u);
    EXPECT_EQ(outlines(mask({"#.#", "...", "#.#"}), 0).size(), 4u);
    EXPECT_EQ(outlines(mask({"###", "#.#", "###"}), 0).size(), 2u);
}

TEST(Outline, SpecksAreLeftOutUnlessTheyAreAll) {
    EXPECT_EQ(outlines(mask({"####.", "####.", "####.", ".....", "....#"}), 4).size(), 1u);
    EXPECT_EQ(outlines(mask({"...", ".#.", "..."}), 100).size(), 1u);
    EXPECT_TRUE(outlines(Mask(5, 5), 1).empty());
}

double distance_to_loop(Vec2d p, const Loop& loop) {
    double least = INFINITY;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2d a = loop[i], b = loop[(i + 1) % loop.size()], ab = b - a, ap = p - a;
        const double all = ab.x * ab.x + ab.y * ab.y;
        const double share = all > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / all, 0.0, 1.0) : 0;
        least = std::min(least, length(ap - ab * share));
    }
    return least;
}

TEST(Outline, SimplifiedLoopsStayWithinTheTolerance) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Loop loop{{0, 0}};
        for (int i = 0; i < 200; ++i)
            loop.push_back(loop.back() + Vec2d{random.between(-1, 1), random.between(-1, 1)});
        const double tolerance = random.between(0.1, 2);
        const Loop fewer = simplified(loop, tolerance);
        EXPECT_LT(fewer.size(), loop.size());
        for (const Vec2d p : loop) EXPECT_LE(distance_to_loop(p, fewer), tolerance + 1e-9);
    }
}

/// A square plate at the scene height z, 20 mm wide, as projected corners.
std::vector<Projected> plate(double z) {
    return {project({-10, -10, z}), project({10, -10, z}), project({10, 10, z}), project({-10, 10, z})};
}
const std::vector<Triangle> kPlateTriangles{{0, 1, 2}, {0, 2, 3}};

TEST(ObjectOutlines, FoamHidesWhatLiesBelowAndNotWhatLiesAbove) {
    const std::vector<Face> foam{{FaceSide::top, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, 1, 1}};
    const ObjectOutlines above = object_outlines(plate(2), kPlateTriangles, foam, 0.1);
    const ObjectOutlines below = object_outlines(plate(-2), kPlateTriangles, foam, 0.1);
    ASSERT_EQ(above.whole.size(), 1u);
    ASSERT_EQ(above.visible.size(), 1u);
    EXPECT_NEAR(signed_area(above.visible[0]), signed_area(above.whole[0]), 1e-9);
    EXPECT_EQ(below.whole.size(), 1u);
    EXPECT_TRUE(below.visible.empty());
}

TEST(ObjectOutlines, APlateIsOutlinedWhereItIsProjected) {
    const std::vector<Projected> corners = plate(0);
    const ObjectOutlines outlines = object_outlines(corners, kPlateTriangles, {}, 0.05);
    ASSERT_EQ(outlines.whole.size(), 1u);
    Loop exact;
    for (const Projected& corner : corners) exact.push_back(corner.at);
    for (const Vec2d p : outlines.whole[0]) EXPECT_LE(distance_to_loop(p, exact), 0.1);
    for (const Vec2d p : exact) EXPECT_LE(distance_to_loop(p, outlines.whole[0]), 0.15);
}

TEST(ObjectOutlines, PointsAndLinesAreStillSomething) {
    const std::vector<Triangle> one{{0, 1, 2}};
    const std::vector<Projected> point(3, project({1, 2, 3}));
    EXPECT_EQ(object_outlines(point, one, {}, 0.1).whole.size(), 1u);
    const std::vector<Projected> line{project({0, 0, 0}), project({1, 2, 3}), project({2, 4, 6})};
    EXPECT_EQ(object_outlines(line, one, {}, 0.1).whole.size(), 1u);
    EXPECT_TRUE(object_outlines({}, {}, {}, 0.1).whole.empty());
}

TEST(SvgText, MarkupAndBytesThatXmlForbidsAreMadeSafe) {
    EXPECT_EQ(xml_text("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &apos;d&apos;");
    EXPECT_EQ(xml_text("h\xC3\xB6he \xE2\x82\xAC \xF0\x9F\x93\xA6"),
              "h\xC3\xB6he \xE2\x82\xAC \xF0\x9F\x93\xA6");
    const std::string replaced = "\xEF\xBF\xBD";
    for (const char* bad :
         {"\x01", "\xFF", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xEF\xBF\xBF", "\xF5\x80\x80\x80"}) {
        const std::string safe = xml_text(bad);
        EXPECT_EQ(safe.substr(0, 3), replaced);
        EXPECT_EQ(safe.size() % 3, 0u) << safe;
    }
}

TEST(SvgText, WrappedLinesAreShortEvenAndComplete) {
    const std::vector<std::string> lines = wrapped("one two three four five six", 14, 4);
    EXPECT_EQ(lines, (std::vector<std::string>{"one two three", "four five six"}));
    EXPECT_EQ(wrapped("aaaaaaaaaa", 4, 9).size(), 3u);
    EXPECT_EQ(wrapped("a b c d e f", 3, 2), (std::vector<std::string>{"a b", "c \xE2\x80\xA6"}));
    EXPECT_TRUE(wrapped("", 10, 3).empty());
    // Wide characters take the room of two, and no line begins with a mark that closes.
    EXPECT_EQ(wrapped("対象物です。次", 10, 9), (std::vector<std::string>{"対象物で", "す。次"}));
    EXPECT_EQ(wrapped("\xC3\xB6\xC3\xB6\xC3\xB6", 2, 9).size(), 2u);
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        std::string bytes;
        for (int n = random.integer(0, 60); n > 0; --n) bytes += static_cast<char>(random.integer(0, 255));
        std::size_t total = 0;
        for (const std::string& line : wrapped(bytes, 10, 1000)) total += line.size();
        const auto spaces = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), ' '));
        EXPECT_LE(total, bytes.size());
        EXPECT_GE(total + spaces, bytes.size());
    }
}

}  // namespace
}  // namespace snug
