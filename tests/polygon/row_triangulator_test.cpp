#include "snug/polygon/row_triangulator.h"

#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "snug/base/grid.h"

#include "tests/support/random.h"

namespace snug {
namespace {

using Point = std::pair<int, int>;  ///< line between rows, position along it

/// A plane of faces with the vertices that stand on their outlines. Each face has its own vertices.
struct Plane {
    Grid<int> faces;
    std::map<std::pair<int, Point>, std::uint32_t> vertex_of;  ///< by face and point
    std::vector<Point> points;                                 ///< by vertex

    [[nodiscard]] int face(int j, int k) const { return faces.contains(j, k) ? faces(j, k) : 0; }
    [[nodiscard]] std::uint32_t vertex(int face, Point point) const {
        const auto found = vertex_of.find({face, point});
        return face == 0 || found == vertex_of.end() ? kNoVertex : found->second;
    }
};

enum class Outline { turns, straight, none };

/// What the outline of a face does at a point, from the four cells around it.
Outline outline(const Plane& plane, int face, Point point) {
    const auto [J, K] = point;
    const bool a = plane.face(J - 1, K - 1) == face, b = plane.face(J - 1, K) == face;
    const bool c = plane.face(J, K - 1) == face, d = plane.face(J, K) == face;
    if (a == b && b == c && c == d) return Outline::none;
    return (a == b && c == d) || (a == c && b == d) ? Outline::straight : Outline::turns;
}

/// Vertices where outlines turn, and by chance where they run straight.
void place_vertices(Plane& plane, test::Random& random, double chance) {
    const std::set<int> faces(plane.faces.begin(), plane.faces.end());
    for (int J = 0; J <= plane.faces.ny(); ++J) {
        for (int K = 0; K <= plane.faces.nz(); ++K) {
            for (const int face : faces) {
                const Outline shape = outline(plane, face, {J, K});
                if (face == 0 || shape == Outline::none) continue;
                if (shape == Outline::straight && !random.chance(chance)) continue;
                plane.vertex_of[{face, {J, K}}] = static_cast<std::uint32_t>(plane.points.size());
                plane.points.push_back({J, K});
            }
        }
    }
}

std::vector<Triangle> triangulated(const Plane& plane) {
    std::vector<Triangle> triangles;
    RowTriangulator triangulator(triangles);
    for (int J = 0; J <= plane.faces.ny(); ++J) {
        std::vector<LineCorner> corners;
        for (int K = 0; K <= plane.faces.nz(); ++K) {
            const LineCorner corner{
                K, plane.vertex(plane.face(J - 1, K - 1), {J, K}), plane.vertex(plane.face(J - 1, K), {J, K}),
                plane.vertex(plane.face(J, K - 1), {J, K}), plane.vertex(plane.face(J, K), {J, K})};
            if ((corner.previous_left & corner.previous_right & corner.next_left & corner.next_right) !=
                kNoVertex)
                corners.push_back(corner);
        }
        std::vector<FaceRun> runs;
        for (int k = 0; k < plane.faces.nz(); ++k) {
            const int face = plane.face(J, k);
            if (face == 0) continue;
            if (k > 0 && plane.face(J, k - 1) == face)
                ++runs.back().end;
            else
                runs.push_back({k, k + 1, face});
        }
        triangulator.step(J, corners, runs);
    }
    return triangles;
}

/// Pieces of outline from vertex to vertex: their number, with the vertices on the way.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> outline_edges(const Plane& plane, int face) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto walk = [&](int lines, int length, auto at, auto is_outline) {
        for (int line = 0; line <= lines; ++line) {
            std::uint32_t from = kNoVertex;
            for (int p = 0; p <= length; ++p) {
                const std::uint32_t here = plane.vertex(face, at(line, p));
                if (here != kNoVertex && from != kNoVertex) ++edges[std::minmax(from, here)];
                if (here != kNoVertex) from = here;
                if (p == length || !is_outline(line, p)) from = kNoVertex;
            }
        }
    };
    walk(
        plane.faces.ny(), plane.faces.nz(),
        [](int line, int p) {
            return Point{line, p};
        },
        [&](int J, int k) { return (plane.face(J - 1, k) == face) != (plane.face(J, k) == face); });
    walk(
        plane.faces.nz(), plane.faces.ny(),
        [](int line, int p) {
            return Point{p, line};
        },
        [&](int K, int j) { return (plane.face(j, K - 1) == face) != (plane.face(j, K) == face); });
    return edges;
}

long long doubled_area(const Plane& plane, const Triangle& t) {
    const auto [aj, ak] = plane.points[t[0]];
    const auto [bj, bk] = plane.points[t[1]];
    const auto [cj, ck] = plane.points[t[2]];
    return 1LL * (bj - aj) * (ck - ak) - 1LL * (bk - ak) * (cj - aj);
}

/// No vertex of the face stands strictly between the ends of an edge.
bool edge_is_free(const Plane& plane, int face, std::uint32_t from, std::uint32_t to) {
    const auto [aj, ak] = plane.points[from];
    const auto [bj, bk] = plane.points[to];
    const int steps = std::gcd(std::abs(bj - aj), std::abs(bk - ak));
    for (int i = 1; i < steps; ++i)
        if (plane.vertex(face, {aj + (bj - aj) / steps * i, ak + (bk - ak) / steps * i}) != kNoVertex)
            return false;
    return true;
}

void expect_triangulated(const Plane& plane) {
    std::map<std::uint32_t, int> face_of;
    for (const auto& [key, vertex] : plane.vertex_of) face_of[vertex] = key.first;
    std::map<int, long long> area;
    std::map<int, std::map<std::pair<std::uint32_t, std::uint32_t>, int>> uses;
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    for (const Triangle& t : triangulated(plane)) {
        const int face = face_of.at(t[0]);
        ASSERT_EQ(face_of.at(t[1]), face);
        ASSERT_EQ(face_of.at(t[2]), face);
        ASSERT_GT(doubled_area(plane, t) * face, 0) << "degenerate or turned the wrong way";
        area[face] += std::abs(doubled_area(plane, t));
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            ++uses[face][std::minmax(from, to)];
            ASSERT_TRUE(directed.insert({from, to}).second) << "an edge twice the same way";
            ASSERT_TRUE(edge_is_free(plane, face, from, to));
        }
    }
    std::map<int, long long> cells;
    for (const int face : plane.faces)
        if (face != 0) cells[face] += 2;
    ASSERT_EQ(area, cells);
    for (const auto& [face, edges] : uses) {
        const auto outer = outline_edges(plane, face);
        for (const auto& [edge, count] : edges) ASSERT_EQ(count, outer.count(edge) != 0 ? 1 : 2);
        for (const auto& [edge, count] : outer) ASSERT_EQ(edges.count(edge), 1u) << "outline not kept";
    }
}

Plane literal(std::initializer_list<std::string> rows) {
    Plane plane{{static_cast<int>(rows.size()), static_cast<int>(rows.begin()->size())}, {}, {}};
    int j = 0;
    for (const std::string& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k)
            plane.faces(j, static_cast<int>(k)) = row[k] == '.' ? 0 : row[k] == '-' ? -1 : row[k] - '0';
        ++j;
    }
    return plane;
}

TEST(Triangulate, SmallShapesHaveAsFewTrianglesAsTheirCornersNeed) {
    // An outline of n corners with h holes takes n + 2h - 2 triangles.
    const std::pair<Plane, std::size_t> cases[] = {
        {literal({"1"}), 2},
        {literal({"11", "11"}), 2},
        {literal({"1.", "11"}), 4},
        {literal({"1.1", "111"}), 6},
        {literal({"111", "1.1", "111"}), 8},
        {literal({"1.", ".1"}), 4},
        {literal({".1", "1."}), 4},
        {literal({"11111", "1.1.1", "11111"}), 14},
        {literal({"12", "21"}), 8},
        {literal({"-1", "1-"}), 8},
    };
    test::Random random(1);
    for (auto [plane, triangles] : cases) {
        place_vertices(plane, random, 0);
        expect_triangulated(plane);
        EXPECT_EQ(triangulated(plane).size(), triangles);
    }
}

TEST(Triangulate, HolesThatTouchInACornerStayApart) {
    for (Plane plane : {literal({"1111", "1.11", "11.1", "1111"}), literal({"1111", "11.1", "1.11", "1111"}),
                        literal({"1.1", ".1.", "1.1"}), literal({"111", "1.1", "11."})}) {
        test::Random random(1);
        place_vertices(plane, random, 0.5);
        expect_triangulated(plane);
    }
}

TEST(Triangulate, VerticesAlongStraightSidesAreAllUsed) {
    test::Random random(1);
    Plane plane = literal({"111", "111"});
    place_vertices(plane, random, 1);
    ASSERT_EQ(plane.points.size(), 10u);
    expect_triangulated(plane);
    EXPECT_EQ(triangulated(plane).size(), 8u);
}

TEST(Triangulate, RandomFacesAreCoveredOnceWithNoVertexInsideAnEdge) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Plane plane{{random.integer(1, 12), random.integer(1, 12)}, {}, {}};
        const int faces = random.integer(1, 3);
        const double foam = random.unit();
        for (int& face : plane.faces)
            if (random.chance(foam)) face = random.integer(1, faces) * (random.chance(0.3) ? -1 : 1);
        place_vertices(plane, random, random.chance(0.3) ? 0 : random.unit());
        expect_triangulated(plane);
        if (HasFatalFailure()) return;
    }
}

/// One arm of cells winds inwards, so the sweep splits and merges the same region again and again.
TEST(Triangulate, ASpiralIsOneRegion) {
    const int n = 41;
    Plane plane{{n, n}, {}, {}};
    int j = 0, k = 0, dj = 0, dk = 1;
    plane.faces(0, 0) = 1;
    const auto free_ahead = [&] {
        const int j1 = j + dj, k1 = k + dk, j2 = j1 + dj, k2 = k1 + dk;
        return plane.faces.contains(j1, k1) && plane.face(j1, k1) == 0 && plane.face(j2, k2) == 0;
    };
    for (int turns = 0; turns < 2;) {
        if (free_ahead()) {
            plane.faces(j += dj, k += dk) = 1;
            turns = 0;
        } else {
            std::tie(dj, dk) = std::pair(dk, -dj);
            ++turns;
        }
    }
    test::Random random(1);
    place_vertices(plane, random, 0.2);
    EXPECT_EQ(triangulated(plane).size(), plane.points.size() - 2);
    expect_triangulated(plane);
}

}  // namespace
}  // namespace snug
