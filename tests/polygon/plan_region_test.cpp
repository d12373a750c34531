#include "snug/polygon/plan_region.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "snug/base/grid.h"

#include "tests/support/random.h"

namespace snug {
namespace {

constexpr int kSize = 14;

/// One cell a step: what the operations must come to, cell by cell.
using Cells = Grid<char>;

Cells random_cells(test::Random& random) {
    Cells cells(kSize, kSize);
    const double share = random.chance(0.3) ? 0.97 : random.unit();
    for (char& cell : cells) cell = random.chance(share) ? 1 : 0;
    return cells;
}

PlanRegion region_of(const Cells& cells) {
    PlanRegion region;
    for (int y = 0; y < cells.ny(); ++y) {
        std::vector<PlanSpan> spans;
        for (int z = 0; z < cells.nz(); ++z) {
            if (cells(y, z) == 0) continue;
            if (!spans.empty() && spans.back().end == z)
                ++spans.back().end;
            else
                spans.push_back({z, z + 1});
        }
        region.append(y, y + 1, std::move(spans));
    }
    return region;
}

template <class Rule>
Cells cells_where(Rule rule) {
    Cells cells(kSize, kSize);
    for (int y = 0; y < kSize; ++y)
        for (int z = 0; z < kSize; ++z) cells(y, z) = rule(y, z) ? 1 : 0;
    return cells;
}

TEST(Region, SetOperationsAreThoseOfTheirCells) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const Cells a = random_cells(random), b = random_cells(random);
        const PlanRegion ra = region_of(a), rb = region_of(b);
        const auto both = [&](int y, int z) { return a(y, z) && b(y, z); };
        const auto either = [&](int y, int z) { return a(y, z) || b(y, z); };
        const auto first_only = [&](int y, int z) { return a(y, z) && !b(y, z); };
        EXPECT_EQ(union_of(ra, rb), region_of(cells_where(either)));
        EXPECT_EQ(intersection(ra, rb), region_of(cells_where(both)));
        EXPECT_EQ(difference(ra, rb), region_of(cells_where(first_only)));
        EXPECT_EQ(area_of(union_of(ra, rb)) + area_of(intersection(ra, rb)), area_of(ra) + area_of(rb));
    }
}

TEST(Region, DilatingReachesEveryPointWithinASquare) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const int by = random.integer(0, 3);
        Cells cells = random_cells(random);
        for (int i = 0; i < kSize; ++i)
            for (int rim = 0; rim < 3; ++rim)
                cells(i, rim) = cells(rim, i) = cells(i, kSize - 1 - rim) = cells(kSize - 1 - rim, i) = 0;
        const Cells wide = cells_where([&](int y, int z) {
            for (int j = 0; j < kSize; ++j)
                for (int k = 0; k < kSize; ++k)
                    if (cells(j, k) && std::abs(j - y) <= by && std::abs(k - z) <= by) return true;
            return false;
        });
        EXPECT_EQ(dilated(region_of(cells), by), region_of(wide));
    }
}

TEST(Region, ErodingKeepsThePointsWithNothingElseWithinASquare) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const int by = random.integer(0, 2);
        const Cells cells = random_cells(random);
        const Cells narrow = cells_where([&](int y, int z) {
            for (int j = y - by; j <= y + by; ++j)
                for (int k = z - by; k <= z + by; ++k)
                    if (!cells.contains(j, k) || !cells(j, k)) return false;
            return true;
        });
        EXPECT_EQ(eroded(region_of(cells), by), region_of(narrow));
    }
}

TEST(Region, PartsAreJoinedBySidesAndTogetherTheWhole) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const PlanRegion region = region_of(random_cells(random));
        PlanRegion all;
        std::int64_t area = 0;
        for (const PlanRegion& part : connected_components(region)) {
            EXPECT_EQ(connected_components(part).size(), 1u);
            all = union_of(all, part);
            area += area_of(part);
        }
        EXPECT_EQ(all, region);
        EXPECT_EQ(area, area_of(region));
    }
    Cells corner(kSize, kSize);
    corner(3, 3) = corner(4, 4) = 1;
    EXPECT_EQ(connected_components(region_of(corner)).size(), 2u);
}

TEST(Region, ContainsItsOutline) {
    const PlanRegion square = region_of(PlanBox{{2, 3}, {5, 7}});
    for (int y = 0; y < 10; ++y)
        for (int z = 0; z < 10; ++z)
            EXPECT_EQ(contains(square, {y, z}), y >= 2 && y <= 5 && z >= 3 && z <= 7) << y << " " << z;
}

}  // namespace
}  // namespace snug
