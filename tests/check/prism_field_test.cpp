#include "snug/check/prism_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace snug {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kYSize = 1.5;
constexpr double kZSize = 2.2;

Grid<PrismSpan> random_spans(test::Random& random) {
    Grid<PrismSpan> spans(random.integer(1, 9), random.integer(1, 9));
    const double filled = random.between(0, 1);
    for (PrismSpan& span : spans) {
        if (!random.chance(filled)) continue;
        const int low = random.integer(-5, 5);
        span = {static_cast<double>(low), static_cast<double>(low + random.integer(0, 6))};
    }
    return spans;
}

/// How far p lies from the box around cell (j, k), between two values of x.
double to_box(Vec3d p, double x_low, double x_high, int j, int k) {
    const auto outside = [](double value, double low, double high) {
        return std::max(std::max(low - value, value - high), 0.0);
    };
    const Vec3d d{outside(p.x, x_low, x_high), outside(p.y, j * kYSize, (j + 1) * kYSize),
                  outside(p.z, k * kZSize, (k + 1) * kZSize)};
    return std::sqrt(dot(d, d));
}

TEST(PrismField, DistancesEqualBruteForceOnBothSides) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Grid<PrismSpan> spans = random_spans(random);
        const PrismField field(spans, 0, kYSize, 0, kZSize);
        for (int i = 0; i < 30; ++i) {
            const Vec3d p{random.between(-12, 12), random.between(-2, 2 + kYSize * spans.ny()),
                          random.between(-2, 2 + kZSize * spans.nz())};
            double inside = kInfinity, outside = kInfinity;
            bool contained = false;
            for (int j = -1; j <= spans.ny(); ++j) {
                for (int k = -1; k <= spans.nz(); ++k) {
                    const PrismSpan s = spans.contains(j, k) ? spans(j, k) : PrismSpan{};
                    // Cells beyond the grid stand for all that lies there.
                    if (s.none()) {
                        outside = std::min(outside, to_box(p, -kInfinity, kInfinity, j, k));
                        continue;
                    }
                    inside = std::min(inside, to_box(p, s.low, s.high, j, k));
                    contained = contained || to_box(p, s.low, s.high, j, k) == 0;
                    outside = std::min(
                        {outside, to_box(p, -kInfinity, s.low, j, k), to_box(p, s.high, kInfinity, j, k)});
                }
            }
            const bool beyond = p.y < 0 || p.y > kYSize * spans.ny() || p.z < 0 || p.z > kZSize * spans.nz();
            if (beyond) outside = 0;
            EXPECT_EQ(field.contains(p), contained);
            const NearestPoint in = field.nearest_inside(p, kInfinity);
            EXPECT_TRUE(in.distance == inside || std::fabs(in.distance - inside) < 1e-12);
            const NearestPoint out = field.nearest_outside(p, kInfinity);
            EXPECT_NEAR(out.distance, outside, 1e-12);
            for (const NearestPoint& n : {in, out}) {
                if (n.distance == kInfinity) continue;
                EXPECT_NEAR(std::sqrt(dot(n.point - p, n.point - p)), n.distance, 1e-12);
            }
            EXPECT_EQ(field.nearest_outside(p, outside * 0.5).distance, outside * 0.5);
        }
    }
}

TEST(PrismField, AnEmptyFieldHasNoInside) {
    for (const PrismField& field :
         {PrismField({}, 0, 1, 0, 1), PrismField(Grid<PrismSpan>(2, 3), 0, 1, 0, 1)}) {
        EXPECT_TRUE(field.bounds().empty());
        EXPECT_FALSE(field.contains({0, 0.5, 0.5}));
        EXPECT_EQ(field.nearest_inside({0, 0.5, 0.5}, 7).distance, 7);
        EXPECT_EQ(field.nearest_outside({0, 0.5, 0.5}, 7).distance, 0);
    }
}

}  // namespace
}  // namespace snug
