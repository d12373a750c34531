#include "snug/mesh/cap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "snug/base/rotation.h"
#include "snug/formats/read.h"
#include "snug/mesh/measure.h"

#include "tests/support/models.h"
#include "tests/support/random.h"
#include "tests/support/shapes.h"
#include "tests/support/small_meshes.h"

namespace snug {
namespace {

using Loop = std::vector<std::uint32_t>;

Mesh without(Mesh mesh, const std::vector<bool>& removed) {
    std::vector<Triangle> kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!removed[t]) kept.push_back(mesh.triangles[t]);
    mesh.triangles = kept;
    return mesh;
}

Mesh only(const Mesh& mesh, std::vector<bool> wanted) {
    wanted.flip();
    return without(mesh, wanted);
}

/// A closed cylinder about y, its base at y = 0. With `wave` the base and what lies below a wavy line is
/// missing.
Mesh cup(int sides, const std::vector<double>& rim) {
    Mesh mesh;
    for (int i = 0; i < sides; ++i) {
        const SineCosine turn = sine_cosine_degrees(360.0 * i / sides);
        for (const double y : {rim[static_cast<std::size_t>(i) % rim.size()], 80.0})
            mesh.vertices.push_back(vec_cast<float>(Vec3d{50 * turn.cosine, y, 50 * turn.sine}));
    }
    mesh.vertices.push_back({0, 80, 0});
    const auto n = static_cast<std::uint32_t>(sides);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
        mesh.triangles.push_back({a, a + 1, b});
        mesh.triangles.push_back({b, a + 1, b + 1});
        mesh.triangles.push_back({b + 1, a + 1, 2 * n});
    }
    return mesh;
}

struct ColumnReach {
    double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// For each column of a coarse y-z grid the extremes of x, by clipping every triangle to it.
class Columns {
  public:
    Columns(const Mesh& mesh, const Rotation& rotation) : reach_(kCount * kCount) {
        for (const Triangle& t : mesh.triangles) {
            std::vector<Vec3d> corners;
            for (const std::uint32_t v : t) corners.push_back(rotation(vec_cast<double>(mesh.vertices[v])));
            add(corners);
        }
    }

    /// How far the point lies beyond what its column reaches; infinite where the column reaches nothing.
    [[nodiscard]] double beyond(Vec3d p) const {
        const ColumnReach& r = reach_[cell(p.y) * kCount + cell(p.z)];
        return std::max({0.0, r.low - p.x, p.x - r.high});
    }

  private:
    static constexpr std::size_t kCount = 40;
    static constexpr double kCell = 15;

    static std::size_t cell(double value) {
        return static_cast<std::size_t>(std::floor(value / kCell) + kCount / 2.0);
    }
    static double start(std::size_t i) { return (static_cast<double>(i) - kCount / 2.0) * kCell; }

    static std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, int axis, double sign,
                                      double bound) {
        std::vector<Vec3d> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec3d p = polygon[i], q = polygon[(i + 1) % polygon.size()];
            const double at_p = sign * (p[axis] - bound), at_q = sign * (q[axis] - bound);
            if (at_p >= 0) kept.push_back(p);
            if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
                kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        return kept;
    }

    void add(const std::vector<Vec3d>& triangle) {
        Box3d box;
        for (const Vec3d& p : triangle) box.include(p);
        for (std::size_t j = cell(box.min.y); j <= cell(box.max.y); ++j) {
            const auto row = clipped(clipped(triangle, 1, 1, start(j)), 1, -1, start(j + 1));
            for (std::size_t k = cell(box.min.z); k <= cell(box.max.z); ++k) {
                ColumnReach& reach = reach_[j * kCount + k];
                for (const Vec3d& p : clipped(clipped(row, 2, 1, start(k)), 2, -1, start(k + 1)))
                    reach = {std::min(reach.low, p.x), std::max(reach.high, p.x)};
            }
        }
    }

    std::vector<ColumnReach> reach_;
};

const Vec3d kTurns[] = {{0, 0, 90},   {0, 0, -90},  {0, 0, 0},   {0, 90, 0},
                        {30, 40, 50}, {10, 20, 80}, {45, 0, 120}};

/// The most that a point of `missing` lies beyond the columns of `mesh`, over many turns.
double shortfall(const Mesh& mesh, const Mesh& missing) {
    double worst = 0;
    for (const Vec3d& turn : kTurns) {
        const Rotation rotation = rotation_from_euler(turn);
        const Columns columns(mesh, rotation);
        for (const Triangle& t : missing.triangles) {
            const Vec3d a = rotation(vec_cast<double>(missing.vertices[t[0]])),
                        b = rotation(vec_cast<double>(missing.vertices[t[1]])),
                        c = rotation(vec_cast<double>(missing.vertices[t[2]]));
            for (const Vec3d& p : {a, b, c, (a + b + c) * (1.0 / 3)})
                worst = std::max(worst, columns.beyond(p));
        }
    }
    return worst;
}

/// How often a loop winds around the origin, as seen along z.
int winding(const std::vector<Vec3d>& loop) {
    int winding = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3d p = loop[i], q = loop[(i + 1) % loop.size()];
        const double side = p.x * q.y - q.x * p.y;
        if (p.y <= 0 && q.y > 0 && side > 0) ++winding;
        if (p.y > 0 && q.y <= 0 && side < 0) --winding;
    }
    return winding;
}

TEST(Cap, AnOpenBoxIsClosedToItsFullVolume) {
    Mesh mesh = test::box_mesh({0, 0, 0}, {2, 3, 4});
    mesh.origin = {1000, 2000, 3000};
    mesh.triangles.resize(10);
    const Mesh closed = capped(mesh, measure(mesh).holes);
    EXPECT_TRUE(measure(closed).watertight);
    EXPECT_NEAR(measure(closed).volume.value(), 24, 1e-9);
    EXPECT_EQ(closed.origin, mesh.origin);
    EXPECT_EQ(closed.triangles.size(), 14u);  // flat: the fan alone
}

TEST(Cap, KeepsTheMeshFirstAndUnchanged) {
    Mesh mesh = cup(24, {0, 3, 1, 4});
    const Mesh closed = capped(mesh, measure(mesh).holes);
    ASSERT_GT(closed.triangles.size(), mesh.triangles.size());
    EXPECT_TRUE(std::equal(mesh.vertices.begin(), mesh.vertices.end(), closed.vertices.begin()));
    EXPECT_TRUE(std::equal(mesh.triangles.begin(), mesh.triangles.end(), closed.triangles.begin()));
}

TEST(Cap, AClosedMeshStaysAsItIs) {
    const Mesh mesh = test::octahedron(2, true);
    EXPECT_EQ(capped(mesh, measure(mesh).holes).triangles, mesh.triangles);
    EXPECT_TRUE(span_of_loops(mesh, measure(mesh).holes).triangles.empty());
}

TEST(Cap, AnyPuncturedSphereBecomesWatertight) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Mesh mesh = test::octahedron(3, true);
        std::vector<bool> removed(mesh.triangles.size());
        for (int i = random.integer(1, 200); i > 0; --i)
            removed[static_cast<std::size_t>(random.integer(0, static_cast<int>(removed.size()) - 1))] = true;
        const Mesh open = without(mesh, removed);
        const auto holes = measure(open).holes;
        EXPECT_TRUE(measure(capped(open, holes)).watertight);
        EXPECT_TRUE(measure(test::joined(open, span_of_loops(open, holes))).watertight);
    }
}

TEST(Span, CoversEveryPointThatALoopRunsAroundFromAnySide) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        Mesh mesh;
        Loop loop;
        for (int i = random.integer(3, 12); i > 0; --i) {
            loop.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(
                vec_cast<float>(Vec3d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}));
        }
        const Mesh span = span_of_loops(mesh, {loop});
        for (int dart = 0; dart < 200; ++dart) {
            const Rotation turn =
                rotation_from_euler({random.between(0, 360), random.between(0, 360), random.between(0, 360)});
            const Vec3d eye{random.between(-1, 1), random.between(-1, 1), 0};
            const auto seen = [&](Vec3f v) { return turn(vec_cast<double>(v)) - eye; };
            std::vector<Vec3d> outline;
            for (const std::uint32_t v : loop) outline.push_back(seen(mesh.vertices[v]));
            if (winding(outline) == 0) continue;
            EXPECT_TRUE(std::any_of(span.triangles.begin(), span.triangles.end(), [&](const Triangle& t) {
                return winding({seen(span.vertices[t[0]]), seen(span.vertices[t[1]]),
                                seen(span.vertices[t[2]])}) != 0;
            }));
        }
    }
}

TEST(Cap, AWavyRimReachesWhatItsFlatBaseReached) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        std::vector<double> rim{0};  // touches the table in one place at least
        for (int i = 1; i < 60; ++i) rim.push_back(random.between(0, 6));
        const Mesh open = cup(60, rim), whole = cup(60, {0});
        const Mesh base = span_of_loops(whole, measure(whole).holes);
        const auto holes = measure(open).holes;
        // The rim's normal leans a little with its waves, and the prism with it.
        const double fan_alone = shortfall(test::joined(open, span_of_loops(open, holes)), base);
        const double left = shortfall(capped(open, holes), base);
        EXPECT_LT(left, 1);
        EXPECT_LT(left, 0.3 * fan_alone);
    }
}

TEST(Cap, ABaseCutOffAboveTheTableReachesDownToTheObjectsOtherFeet) {
    // Two feet; the base of one was cut off 4 mm above the table.
    const Mesh foot = cup(40, {4});
    Mesh other = test::box_mesh({80, 0, -20}, {120, 80, 20});
    const Mesh object = test::joined(foot, other);
    const Mesh whole = cup(40, {0});
    const Mesh base = span_of_loops(whole, measure(whole).holes);
    EXPECT_LT(shortfall(capped(object, measure(object).holes), base), 1e-3);
    EXPECT_GT(shortfall(capped(foot, measure(foot).holes), base), 3);
}

TEST(Cap, ALoopInTheMiddleOfTheObjectDoesNotReachToItsEnds) {
    const Mesh foot = cup(40, {30});
    const Mesh object = test::joined(foot, test::box_mesh({80, 0, -20}, {120, 80, 20}));
    const Mesh closed = capped(object, measure(object).holes);
    EXPECT_EQ(closed.triangles.size(), object.triangles.size() + 40);
}

TEST(Cap, ACrackAroundABulgeGetsNoFin) {
    // A ball slit along half of its equator.
    Mesh mesh = test::octahedron(4, true);
    std::vector<bool> removed(mesh.triangles.size());
    for (std::size_t t = 0; t < removed.size(); ++t)
        removed[t] = std::all_of(mesh.triangles[t].begin(), mesh.triangles[t].end(), [&](std::uint32_t v) {
            return std::fabs(mesh.vertices[v].z) < 0.15f && mesh.vertices[v].x > -0.1f;
        });
    const Mesh open = without(mesh, removed);
    const auto holes = measure(open).holes;
    ASSERT_FALSE(holes.empty());
    const Mesh closed = capped(open, holes);
    for (const Vec3f& v : closed.vertices) EXPECT_LT(dot(v, v), 1.02f);
}

TEST(Cap, ALoopWithoutAreaGetsItsFanAlone) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const Mesh closed = capped(mesh, {{0, 1, 3, 2}});
    EXPECT_EQ(closed.triangles.size(), 4u);
    for (const Vec3f& v : closed.vertices)
        EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
}

struct BaseCut {
    const char* name;
    double steepest;   ///< of the removed triangles' normals: their y is below this
    double height;     ///< share of the bunny's height below which they lie
    double tilt;       ///< of the plane below which they lie
    double tolerance;  ///< mm by which the removed base may reach beyond the capped bunny
};

class BunnyWithoutBase : public testing::TestWithParam<BaseCut> {};

TEST_P(BunnyWithoutBase, IsCutAtLeastWhereTheWholeOneIsOnceCapped) {
    const auto file = test::model_file("stanford-bunny.obj");
    if (!file) GTEST_SKIP() << "the shared models are not here";
    const Mesh read = read_obj(*file).value();
    const Mesh bunny = scaled(read, 1000);  // its unit is the metre
    const Box3d box = bounds(bunny);
    const BaseCut cut = GetParam();
    std::vector<bool> removed;
    for (const Triangle& t : bunny.triangles) {
        const Vec3d a = vec_cast<double>(bunny.vertices[t[0]]), b = vec_cast<double>(bunny.vertices[t[1]]),
                    c = vec_cast<double>(bunny.vertices[t[2]]), n = cross(b - a, c - a);
        const auto low = [&](Vec3d p) {
            return p.y < box.min.y + cut.height * box.size().y + cut.tilt * (p.z - box.centre().z);
        };
        removed.push_back(n.y <= cut.steepest * std::sqrt(dot(n, n)) && low(a) && low(b) && low(c));
    }
    const Mesh open = without(bunny, removed), base = only(bunny, removed);
    ASSERT_GT(base.triangles.size(), 1000u);
    const auto holes = measure(open).holes;
    EXPECT_GT(shortfall(open, base), 10);  // foam would fill it
    const double left = shortfall(capped(open, holes), base);
    EXPECT_LE(left, cut.tolerance);
    RecordProperty("shortfall_mm", std::to_string(left));
}

// Where only what faces the table is gone, nothing is left out. Below a plane the bunny's flanks are gone,
// too: what bulged beyond the rim is not known to any cap.
INSTANTIATE_TEST_SUITE_P(, BunnyWithoutBase,
                         testing::Values(BaseCut{"steep", -0.7, 0.03, 0, 0.01},
                                         BaseCut{"half_steep", -0.5, 0.03, 0, 0.01},
                                         BaseCut{"thin", 1, 0.01, 0, 0.01}, BaseCut{"plane", 1, 0.03, 0, 1},
                                         BaseCut{"tilted", 1, 0.03, 0.05, 2}),
                         [](const auto& cut) { return std::string(cut.param.name); });

}  // namespace
}  // namespace snug
