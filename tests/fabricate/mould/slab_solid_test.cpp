#include "snug/fabricate/mould/slab_solid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/rotation.h"
#include "snug/polygon/lattice.h"
#include "snug/polygon/plan_outline.h"

#include "tests/support/cases.h"
#include "tests/support/closedness.h"
#include "tests/support/random.h"

namespace snug {
namespace {

struct RandomField {
    Grid<std::uint16_t> heights;
    std::vector<int> levels{0}, y{0}, z{0};
    Draft draft;

    explicit RandomField(test::Random& random) : heights(random.integer(1, 10), random.integer(1, 10)) {
        const int nx = random.integer(1, 8), least = random.chance(0.7) ? 1 : 0;
        for (auto& height : heights) height = static_cast<std::uint16_t>(random.integer(least, nx));
        const bool even = random.chance(0.5);
        const int block = random.integer(500, 20000);
        const auto add_lines = [&](std::vector<int>& lines, int count) {
            for (int i = 0; i < count; ++i)
                lines.push_back(lines.back() + (even ? block : random.integer(300, 20000)));
        };
        add_lines(levels, nx);
        add_lines(y, heights.ny());
        add_lines(z, heights.nz());
        const SineCosine lean = sine_cosine_degrees(random.chance(0.2) ? 0 : random.between(0, 15));
        draft = {lean.sine / lean.cosine, levels[static_cast<std::size_t>(random.integer(0, nx))]};
    }
    [[nodiscard]] SteppedField view() const { return {heights, levels, y, z}; }
    [[nodiscard]] std::vector<DraftSlab> slabs() const {
        return draft_slabs(view(), 0, static_cast<int>(levels.size()) - 1, draft, {});
    }
    /// As it should be: the highest of all columns, less what their faces fall from here to there.
    [[nodiscard]] bool contains(Vec3d p, double margin) const {
        for (int j = 0; j < heights.ny(); ++j)
            for (int k = 0; k < heights.nz(); ++k) {
                const int top = levels[heights(j, k)];
                if (p.x > top + margin) continue;
                const auto beyond = [](double at, int begin, int end) {
                    return std::max({begin - at, at - end, 0.0});
                };
                const double away =
                    std::max(beyond(p.y, y[static_cast<std::size_t>(j)], y[static_cast<std::size_t>(j) + 1]),
                             beyond(p.z, z[static_cast<std::size_t>(k)], z[static_cast<std::size_t>(k) + 1]));
                const double moved =
                    draft.slope * (std::max<double>(draft.from - p.x, 0) - std::max(draft.from - top, 0));
                if (away <= moved + margin) return true;
            }
        return false;
    }
};

/// One whole that may be of several pieces.
StepSolid meshed(const RandomField& field) {
    const auto slabs = field.slabs();
    StepSolid all;
    if (slabs.empty()) return all;
    for (const PlanRegion& piece : connected_components(bottom_of(slabs.back(), field.view().box()))) {
        std::vector<DraftSlab> own;
        for (const DraftSlab& slab : slabs)
            if (PlanRegion region = intersection(slab.region, piece); !region.empty())
                own.push_back({slab.top, slab.bottom, slab.growth, std::move(region)});
        const StepSolid solid = slab_solid(own, field.view().box());
        const auto first = static_cast<std::uint32_t>(all.points.size());
        all.points.insert(all.points.end(), solid.points.begin(), solid.points.end());
        for (const Triangle& t : solid.triangles)
            all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return all;
}

std::vector<Vec3f> as_floats(const StepSolid& solid) {
    std::vector<Vec3f> points;
    for (const Vec3i p : solid.points) points.push_back(vec_cast<float>(p));
    return points;
}

TEST(SlabSolid, IsClosedAndNothingOverhangsOrIsFlat) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(1500)); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const RandomField field(random);
        const StepSolid solid = meshed(field);
        if (solid.empty()) continue;
        ASSERT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
        ASSERT_TRUE(test::closed_when_welded(as_floats(solid), solid.triangles));
        for (const Triangle& t : solid.triangles) {
            const Vec3d a = vec_cast<double>(solid.points[t[0]]), b = vec_cast<double>(solid.points[t[1]]),
                        c = vec_cast<double>(solid.points[t[2]]);
            const Vec3d normal = cross(b - a, c - a);
            ASSERT_GT(dot(normal, normal), 0);
            if (normal.x < 0) {
                ASSERT_EQ(std::max({a.x, b.x, c.x}), 0);
            }
        }
    }
}

TEST(SlabSolid, GrowingMovesEveryCornerAndMakesNone) {
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(500)); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const RandomField field(random);
        for (const DraftSlab& slab : field.slabs()) {
            auto moved = offset_corners(outline_corners(slab.region), slab.growth, field.view().box());
            std::sort(moved.begin(), moved.end(),
                      [](PlanPoint a, PlanPoint b) { return a.y != b.y ? a.y < b.y : a.z < b.z; });
            std::vector<PlanPoint> corners;
            for (const OutlineCorner& corner : outline_corners(bottom_of(slab, field.view().box())))
                corners.push_back(corner.at);
            ASSERT_EQ(moved, corners);
        }
    }
}

/// The crossings of an upright line from below, signed.
int winding(const StepSolid& solid, Vec3d p) {
    int turns = 0;
    for (const Triangle& t : solid.triangles) {
        const Vec3d a = vec_cast<double>(solid.points[t[0]]) - p,
                    b = vec_cast<double>(solid.points[t[1]]) - p,
                    c = vec_cast<double>(solid.points[t[2]]) - p;
        const auto side = [](Vec3d u, Vec3d v) { return u.y * v.z - u.z * v.y; };
        const double ab = side(a, b), bc = side(b, c), ca = side(c, a), area = ab + bc + ca;
        if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
        if ((a.x * bc + b.x * ca + c.x * ab) / area > 0) turns += area > 0 ? 1 : -1;
    }
    return turns;
}

/// What is within is what leaning columns fill, but for the gaps that close within one slab.
TEST(SlabSolid, IsTheUnionOfLeaningColumns) {
    const int seeds = test::cases(300);
    int inside = 0, filled = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(seeds); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const RandomField field(random);
        const StepSolid solid = meshed(field);
        for (int i = 0; i < 100; ++i) {
            const Vec3d p{random.between(0, field.levels.back()), random.between(0, field.y.back()),
                          random.between(0, field.z.back())};
            const int turns = winding(solid, p);
            ASSERT_TRUE(turns == 0 || turns == 1);
            if (field.contains(p, -3)) {
                ASSERT_EQ(turns, 1);
            }
            inside += turns;
            if (turns == 1 && !field.contains(p, 3)) ++filled;
        }
    }
    EXPECT_GT(inside, seeds * 50 / 3);
    EXPECT_LT(filled, inside / 50);
}

TEST(SlabSolid, AColumnBecomesAFrustum) {
    const Grid<std::uint16_t> heights = [] {
        Grid<std::uint16_t> grid(3, 3, 1);
        grid(1, 1) = 2;
        return grid;
    }();
    const std::vector<int> levels{0, 1000, 3000}, lines{0, 5000, 10000, 15000};
    const auto slabs = draft_slabs({heights, levels, lines, lines}, 0, 2, {0.1, 3000}, {});
    const StepSolid solid = slab_solid(slabs, {{0, 0}, {15000, 15000}});
    // Sides of 5000 at the top and 5400 at the foot, 2000 high.
    const double frustum = 2000.0 / 3 * (5000.0 * 5000 + 5400.0 * 5400 + 5000.0 * 5400);
    EXPECT_NEAR(volume_of(solid), 1000.0 * 15000 * 15000 + frustum, 1);
    EXPECT_EQ(solid.points.size(), 16u);
}

TEST(SlabSolid, BoresAreBlindHolesInFlatFaces) {
    const Grid<std::uint16_t> heights(2, 2, 1);
    const std::vector<int> levels{0, 20000}, lines{0, 15000, 30000};
    const auto slabs = draft_slabs({heights, levels, lines, lines}, 0, 1, {}, {});
    PrintOptions options;
    options.dowel_diameter_mm = 2;
    options.dowel_length_mm = 6;
    std::vector<SlabBore> bores;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool after : {false, true})
            for (const double at : {7.0, 13.0}) {
                const Bore bore{axis, 0, {at, at, at}, 0, 0};
                bores.push_back(slab_bore(bore, after, {}, after ? 0 : axis == 0 ? 20000 : 30000, options));
            }
    const StepSolid solid = slab_solid(slabs, {{0, 0}, {30000, 30000}}, bores);
    EXPECT_TRUE(test::every_edge_has_two_triangles(solid.triangles));
    const double steps3 = kStepsPerMm * double{kStepsPerMm} * kStepsPerMm;
    EXPECT_NEAR(20000.0 * 30000 * 30000 - volume_of(solid), 12 * bore_volume_mm3(options) * steps3,
                2e-3 * 12 * bore_volume_mm3(options) * steps3);
}

}  // namespace
}  // namespace snug
