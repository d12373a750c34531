#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "snug/search/mask.h"
#include "snug/search/mask_clash.h"
#include "snug/search/mask_packer.h"
#include "snug/search/mask_rooms.h"

#include "tests/support/cases.h"
#include "tests/support/random.h"

// Masks against sets of cells.

namespace snug {
namespace {

using test::Random;

using Cells = std::set<std::pair<int, int>>;

/// With something in its first and last row and column.
BitMask random_mask(Random& random, int most_rows, int most_columns) {
    BitMask mask(random.integer(1, most_rows), random.integer(1, most_columns));
    const auto any_row = [&] { return random.integer(0, mask.rows() - 1); };
    const auto any_column = [&] { return random.integer(0, mask.columns() - 1); };
    for (int i = random.integer(0, mask.rows() * mask.columns()); i > 0; --i)
        mask.set(any_row(), any_column());
    mask.set(0, any_column());
    mask.set(mask.rows() - 1, any_column());
    mask.set(any_row(), 0);
    mask.set(any_row(), mask.columns() - 1);
    return mask;
}

Cells cells_of(const BitMask& mask, int row, int column) {
    Cells cells;
    for (int j = 0; j < mask.rows(); ++j)
        for (int k = 0; k < mask.columns(); ++k)
            if (mask(j, k)) cells.insert({row + j, column + k});
    return cells;
}

/// Fewer than the gap lie between some two cells both ways.
bool too_near(const Cells& a, const Cells& b, MaskGap gap) {
    for (const auto& [j, k] : a)
        for (const auto& [row, column] : b)
            if (std::abs(j - row) <= gap.rows && std::abs(k - column) <= gap.columns) return true;
    return false;
}

TEST(Masks, MeetExactlyWhereTheirCellsDo) {
    Random random(1);
    for (int i = 0; i < test::cases(200, 40); ++i) {
        const BitMask a = random_mask(random, 9, 150), b = random_mask(random, 9, 150);
        const int j = random.integer(-9, 9), k = random.integer(-150, 150);
        EXPECT_EQ(a.meets(b, j, k), too_near(cells_of(a, 0, 0), cells_of(b, j, k), {})) << i;
        EXPECT_EQ(a.count(), static_cast<long long>(cells_of(a, 0, 0).size()));
    }
}

TEST(Masks, ClashWhereTheGapIsNotKeptAndAreMovedApartByTheDepth) {
    Random random(2);
    for (int i = 0; i < test::cases(60, 10); ++i) {
        const BitMask a = random_mask(random, 7, 9), b = random_mask(random, 7, 9);
        const MaskGap gap{random.integer(0, 2), random.integer(0, 2)};
        const ClashMap map(runs_of(a), runs_of(b), gap);
        const BitMask one = grown(a, gap), other = grown(b, gap);
        const auto clash = [&](int j, int k) { return too_near(cells_of(a, 0, 0), cells_of(b, j, k), gap); };
        for (int j = -11; j <= 11; ++j)
            for (int k = -13; k <= 13; ++k) {
                ASSERT_EQ(map.depth(j, k) > 0, clash(j, k)) << i << ": " << j << " " << k;
                ASSERT_EQ(one.meets(other, j, k), clash(j, k));
            }
        // No shift shorter than a third of the depth parts them, since a step costs 3 at least.
        const int j = random.integer(-2, 2), k = random.integer(-2, 2), steps = (map.depth(j, k) - 1) / 4;
        for (int dj = -steps; dj <= steps; ++dj)
            for (int dk = -(steps - std::abs(dj)); dk <= steps - std::abs(dj); ++dk)
                EXPECT_TRUE(map.depth(j, k) == 0 || clash(j + dj, k + dk));
    }
}

MaskProblem random_problem(Random& random, int pieces, int most_ways, int most_side, MaskGap gap) {
    MaskProblem problem;
    problem.gap = gap;
    for (int i = 0; i < pieces; ++i) {
        MaskPiece piece;
        for (int way = random.integer(1, most_ways); way > 0; --way) {
            piece.shapes.push_back(static_cast<int>(problem.shapes.size()));
            problem.shapes.push_back({random_mask(random, most_side, most_side), 1, random.integer(1, 9)});
        }
        problem.pieces.push_back(std::move(piece));
    }
    return problem;
}

void expect_apart(const MaskProblem& problem, const PackedMasks& packed) {
    std::vector<Cells> cells;
    for (const LaidMask& at : packed.layout) {
        const BitMask& mask = problem.shapes[static_cast<std::size_t>(at.shape)].mask;
        EXPECT_TRUE(at.row >= 0 && at.column >= 0 && at.row + mask.rows() <= packed.rows &&
                    at.column + mask.columns() <= packed.columns);
        cells.push_back(cells_of(mask, at.row, at.column));
    }
    for (std::size_t a = 0; a < cells.size(); ++a)
        for (std::size_t b = a + 1; b < cells.size(); ++b) {
            const auto& pieces = problem.pieces;
            const bool together = pieces[a].group >= 0 && pieces[a].group == pieces[b].group;
            if (packed.layout[a].bin != packed.layout[b].bin) continue;
            EXPECT_FALSE(too_near(cells[a], cells[b], together ? MaskGap{} : problem.gap)) << a << " " << b;
        }
}

/// Of all ways to lay two pieces beside each other.
long long least_of_two(const MaskProblem& problem, const RoomTask& task) {
    long long least = std::numeric_limits<long long>::max();
    for (const int one : problem.pieces[0].shapes)
        for (const int other : problem.pieces[1].shapes) {
            const BitMask& a = problem.shapes[static_cast<std::size_t>(one)].mask;
            const BitMask& b = problem.shapes[static_cast<std::size_t>(other)].mask;
            const int rows = a.rows() + b.rows() + problem.gap.rows;
            const int columns = a.columns() + b.columns() + problem.gap.columns;
            for (int j = -rows; j <= rows; ++j)
                for (int k = -columns; k <= columns; ++k) {
                    const int high = std::max(a.rows(), j + b.rows()) - std::min(0, j);
                    const int wide = std::max(a.columns(), k + b.columns()) - std::min(0, k);
                    if (task.price(high, wide) < least &&
                        !too_near(cells_of(a, 0, 0), cells_of(b, j, k), problem.gap))
                        least = task.price(high, wide);
                }
        }
    return least;
}

RoomTask task_with_walls(Random& random, long long work) {
    RoomTask task;
    const int rows = random.integer(0, 6), columns = random.integer(0, 6);
    task.price = [rows, columns](int y, int z) { return 1LL * (y + rows) * (z + columns); };
    task.most_rows = task.most_columns = 60;
    task.heights = {1};
    task.work = work;
    return task;
}

TEST(MaskRooms, OfTwoPiecesAreTheLeastThatExist) {
    Random random(3);
    for (int i = 0; i < test::cases(24, 6); ++i) {
        const MaskProblem problem =
            random_problem(random, 2, 4, 6, {random.integer(0, 1), random.integer(0, 2)});
        const RoomTask task = task_with_walls(random, 1'500'000);
        MaskPacker packer(problem, static_cast<std::uint64_t>(i));
        const auto packed = smallest_room(packer, task);
        ASSERT_TRUE(packed);
        EXPECT_EQ(packed->price, least_of_two(problem, task)) << i;
        EXPECT_GE(packed->price, least_price(problem, task));
        expect_apart(problem, *packed);
    }
}

TEST(MaskRooms, KeepPiecesApartAreToldAsTheyGetBetterAndAreTheSameEveryTime) {
    Random random(4);
    for (int i = 0; i < test::cases(20, 5); ++i) {
        MaskProblem problem = random_problem(random, random.integer(2, 12), 3, 12,
                                             {random.integer(0, 2), random.integer(0, 2)});
        if (random.chance(0.5)) problem.pieces[0].group = problem.pieces[1].group = 0;
        RoomTask task = task_with_walls(random, 3'000'000);
        if (random.chance(0.3)) task.heights = {1, 1};
        std::vector<long long> told;
        MaskPacker packer(problem, 7), again(problem, 7);
        const auto packed = smallest_room(packer, task, [&](const PackedMasks& better) {
            EXPECT_TRUE(told.empty() || better.price < told.back());
            told.push_back(better.price);
            expect_apart(problem, better);
        });
        ASSERT_TRUE(packed);
        EXPECT_EQ(told.back(), packed->price);
        EXPECT_GE(packed->price, least_price(problem, task));
        const auto same = smallest_room(again, task);
        EXPECT_EQ(same->layout, packed->layout);
        EXPECT_EQ(again.work(), packer.work());
    }
}

TEST(MaskRooms, StripsGetShorterThanWhatIsLaidInOrder) {
    Random random(5);
    int shorter = 0;
    for (int i = 0; i < 5; ++i) {
        const MaskProblem problem = random_problem(random, 15, 2, 9, {0, 0});
        MaskPacker packer(problem, 1);
        std::vector<int> rows;
        const auto packed = shortest_strip(packer, 20, 20'000'000,
                                           [&](const PackedMasks& better) { rows.push_back(better.rows); });
        ASSERT_TRUE(packed);
        EXPECT_TRUE(std::is_sorted(rows.rbegin(), rows.rend()));
        EXPECT_LE(packed->columns, 20);
        expect_apart(problem, *packed);
        shorter += packed->rows < rows.front();
    }
    EXPECT_GE(shorter, 4);
}

TEST(MaskPacker, LeavesLockedPiecesAndRefusedPlaces) {
    Random random(6);
    int laid = 0;
    for (int i = 0; i < test::cases(30, 5); ++i) {
        MaskProblem problem = random_problem(random, 4, 2, 4, {1, 1});
        problem.pieces[0].locked = LaidMask{problem.pieces[0].shapes.front(), 0, 5, 6};
        MaskRoom room{14, 14, {1}, {}};
        for (const MaskShape& shape : problem.shapes) {
            BitMask refused(14, 14);
            for (int j = 0; j < 14; ++j)
                for (int k = 0; k < 14; ++k)
                    if ((j + k) % 3 == 0) refused.set(j, k);
            room.refused.push_back(refused);
            EXPECT_GT(shape.mask.rows(), 0);
        }
        MaskPacker packer(problem, 3);
        MaskLayout layout = packer.laid_in_order(room, 0);
        if (!packer.separate(room, layout, 200, 50'000'000)) continue;
        EXPECT_EQ(layout[0], *problem.pieces[0].locked);
        for (std::size_t piece = 1; piece < 4; ++piece)
            EXPECT_NE((layout[piece].row + layout[piece].column) % 3, 0);
        expect_apart(problem, {14, 14, layout, 0});
        ++laid;
    }
    EXPECT_GT(laid, 0);
}

}  // namespace
}  // namespace snug
