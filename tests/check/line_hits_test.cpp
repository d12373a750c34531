#include "snug/check/line_hits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace snug {
namespace {

struct SampledSurface {
    std::vector<Vec3d> vertices;
    std::vector<Triangle> triangles;
};

/// Random rings of vertices, joined to a torus: it crosses itself freely. Vertices snap to lines, or to y and
/// z that lines have, or to column faces, to provoke ties.
SampledSurface random_closed_surface(test::Random& random, const DesignSpace& space) {
    SampledSurface s;
    const int rings = random.integer(2, 6), around = random.integer(3, 9);
    const auto snapped = [&](int axis) {
        const double cell = space.block_mm[axis] / (random.chance(0.5) ? 256 : 1);
        const double p = random.between(-0.7, 0.7) * space.size()[axis];
        return random.chance(0.6) ? (std::floor(p / cell) + (cell < 1 ? 0.5 : 0)) * cell : p;
    };
    const LineLattice lattice(space);
    for (int i = 0; i < rings * around; ++i) {
        Vec3d p{random.between(-50, 50), snapped(1), snapped(2)};
        if (random.chance(0.5)) {
            const int row = random.integer(0, lattice.rows() - 1),
                      column = random.integer(0, lattice.columns() - 1);
            p.y = space.face(1, 0) + lattice.u(row, column) * lattice.mm_per_unit_y();
            p.z = space.face(2, 0) + lattice.v(row, column) * lattice.mm_per_unit_z();
        }
        s.vertices.push_back(p);
    }
    const auto at = [&](int ring, int step) {
        return static_cast<std::uint32_t>(ring % rings * around + step % around);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int step = 0; step < around; ++step) {
            s.triangles.push_back({at(ring, step), at(ring + 1, step), at(ring, step + 1)});
            s.triangles.push_back({at(ring, step + 1), at(ring + 1, step), at(ring + 1, step + 1)});
        }
    }
    return s;
}

DesignSpace random_space(test::Random& random) {
    return {{10, random.integer(1, 5), random.integer(1, 5)},
            {10, random.between(5, 20), random.between(5, 20)}};
}

TEST(LineLattice, TheLinesOfAColumnHaveAllDifferentHeightsAndBreadths) {
    const LineLattice lattice(DesignSpace{{2, 2, 3}, {10, 15, 22}});
    std::set<std::int32_t> us, vs;
    for (int row = 16; row < 32; ++row) {
        for (int column = 32; column < 48; ++column) {
            us.insert(lattice.u(row, column));
            vs.insert(lattice.v(row, column));
            EXPECT_EQ(lattice.u(row, column) / LineLattice::kUnitsPerCell, row);
            EXPECT_EQ(lattice.v(row, column) / LineLattice::kUnitsPerCell, column);
        }
    }
    EXPECT_EQ(us.size(), 256u);
    EXPECT_EQ(vs.size(), 256u);
}

TEST(LineLattice, LinesThroughAClosedSurfaceComeOutAgain) {
    std::size_t crossings = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const DesignSpace space = random_space(random);
        const SampledSurface s = random_closed_surface(random, space);
        const auto swept =
            sweep_lines(LineLattice(space), s.vertices, s.triangles, [&](const LineBand& band) {
                for (int row = band.first_row; row < band.end_row(); ++row) {
                    for (int column = 0; column < band.columns; ++column) {
                        int winding = 0;
                        for (const Crossing& c : band.line(row, column)) winding += c.turn;
                        ASSERT_EQ(winding, 0);
                        crossings += band.line(row, column).size();
                    }
                }
            });
        ASSERT_TRUE(swept);
    }
    EXPECT_GT(crossings, 100000u);
}

TEST(LineLattice, CoarserLinesDivideTheSpaceAndStandInTheirCells) {
    const DesignSpace space{{2, 5, 7}, {10, 15, 22}};
    for (int bits = LineLattice::kFinest; bits <= LineLattice::kCoarsest; ++bits) {
        const LineLattice lattice(space, bits);
        double shares = 0;
        for (int row = 0; row < lattice.rows(); ++row) {
            for (int column = 0; column < lattice.columns(); ++column) {
                shares += lattice.share(row, column);
                ASSERT_EQ(lattice.u(row, column) >> bits, row);
                ASSERT_EQ(lattice.v(row, column) >> bits, column);
                ASSERT_LT(lattice.j(row, column), space.blocks.y);
                ASSERT_LT(lattice.k(row, column), space.blocks.z);
            }
        }
        EXPECT_DOUBLE_EQ(shares / lattice.lines_per_column(), 5 * 7);
    }
}

/// What the sweep finds on each line, in the order in which it shows them.
using LineCrossings = std::vector<std::tuple<int, int, double, int>>;

LineCrossings swept_crossings(const LineLattice& lattice, const SampledSurface& s, std::size_t most_hits,
                              std::size_t& largest_band) {
    LineCrossings found;
    int next_row = 0;
    const auto swept = sweep_lines(
        lattice, s.vertices, s.triangles,
        [&](const LineBand& band) {
            EXPECT_LE(band.first_row, next_row);
            largest_band = std::max(largest_band, band.crossings.size());
            for (int row = band.first_row; row < band.end_row(); ++row)
                for (int column = band.first_column; column < band.end_column(); ++column)
                    for (const Crossing& c : band.line(row, column))
                        found.emplace_back(row, column, c.x, c.turn);
            if (band.end_column() == lattice.columns()) next_row = band.end_row();
        },
        {}, most_hits);
    EXPECT_TRUE(swept);
    EXPECT_EQ(next_row, lattice.rows());
    std::sort(found.begin(), found.end());
    return found;
}

TEST(LineHits, TheSweepFindsWhatTryingEveryLineFindsHoweverItIsDivided) {
    for (std::uint64_t seed = 100; seed < 125; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const DesignSpace space = random_space(random);
        const LineLattice lattice(space, seed < 110 ? LineLattice::kFinest : random.integer(12, 19));
        const SampledSurface s = random_closed_surface(random, space);
        std::vector<SnappedVertex> v;
        for (const Vec3d& p : s.vertices) v.push_back(lattice.snap(p));
        LineCrossings expected;
        for (int row = 0; row < lattice.rows(); ++row) {
            for (int column = 0; column < lattice.columns(); ++column) {
                for (const Triangle& t : s.triangles) {
                    const auto c =
                        crossing(lattice.u(row, column), lattice.v(row, column), v[t[0]], v[t[1]], v[t[2]]);
                    if (c) expected.emplace_back(row, column, c->x, c->turn);
                }
            }
        }
        std::sort(expected.begin(), expected.end());
        std::size_t largest_band = 0;
        EXPECT_EQ(swept_crossings(lattice, s, 1 << 20, largest_band), expected);
        largest_band = 0;
        EXPECT_EQ(swept_crossings(lattice, s, 1, largest_band), expected);
        EXPECT_LE(largest_band, s.triangles.size() * static_cast<std::size_t>(lattice.lines_along_column()));
    }
}

TEST(LineHits, CrossingsLieOnTheTriangleAndKnowWhichWayItFaces) {
    const DesignSpace space{{4, 1, 1}, {10, 16, 32}};
    const LineLattice lattice(space);
    // x = 3 + y / 2 - z / 4, counter-clockwise seen from +x.
    const auto on_plane = [](double y, double z) { return Vec3d{3 + y / 2 - z / 4, y, z}; };
    const std::vector<Vec3d> vertices{on_plane(-100, -100), on_plane(100, -100), on_plane(0, 200)};
    for (const bool flipped : {false, true}) {
        const std::vector<Triangle> triangles{flipped ? Triangle{0, 2, 1} : Triangle{0, 1, 2}};
        const auto swept = sweep_lines(lattice, vertices, triangles, [&](const LineBand& band) {
            for (int l = 0; l < 16; ++l) {
                for (int m = 0; m < 16; ++m) {
                    const auto hits = band.line(l, m);
                    ASSERT_EQ(hits.size(), 1u);
                    const double y = -8 + l + (m + 0.5) / 16, z = -16 + 2 * (m + (l + 0.5) / 16);
                    EXPECT_NEAR(hits[0].x, 3 + y / 2 - z / 4, 1e-3);
                    EXPECT_EQ(hits[0].turn, flipped ? 1 : -1);
                }
            }
        });
        ASSERT_TRUE(swept);
    }
}

TEST(LineHits, SurfacesFarOutsideTheSpaceOrSeenEdgeOnAreNotMet) {
    const DesignSpace space{{4, 2, 2}, {10, 10, 10}};
    const std::vector<Vec3d> vertices{{0, 1e30, 0},  {0, 1e30, 1e30}, {0, 2e30, 0},
                                      {-9, 0.5, -9}, {9, 0.5, -9},    {0, 0.5, 9}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}, {3, 3, 3}};
    const auto swept = sweep_lines(LineLattice(space), vertices, triangles,
                                   [](const LineBand& band) { EXPECT_TRUE(band.crossings.empty()); });
    ASSERT_TRUE(swept);
}

TEST(LineHits, SweepingCanBeCancelled) {
    const DesignSpace space{{4, 60, 60}, {10, 10, 10}};
    const std::vector<Vec3d> vertices{{0, -1000, -1000}, {0, 2000, -1000}, {0, -1000, 2000}};
    const std::vector<Triangle> triangles(20, Triangle{0, 1, 2});
    const auto swept = sweep_lines(
        LineLattice(space), vertices, triangles, [](const LineBand&) {}, [](double) { return false; });
    ASSERT_FALSE(swept);
    EXPECT_EQ(swept.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace snug
