#include "snug/fabricate/sheets/liner_slits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/sheets/cut_piece.h"
#include "snug/fabricate/sheets/sheets_pack.h"
#include "snug/words/words.h"

#include "tests/support/cases.h"
#include "tests/support/pack_file.h"
#include "tests/support/sheet_foams.h"

namespace snug {
namespace {

using test::CutFoams;
using test::Random;

constexpr double kNear = 0.01;  // mm; lines lie on the lattice

/// Along rows or along columns, whichever is farther, from a place to the nearest cell that `holds`.
template <class Holds>
double distance_to(const SheetStack& stack, Vec2d p, Holds holds) {
    double nearest = 1e9;
    for (int row = -1; row <= stack.rows(); ++row)
        for (int column = -1; column <= stack.columns(); ++column) {
            if (!holds(row, column)) continue;
            const double x = std::max(
                             {column * stack.cell_mm.x - p.x, p.x - (column + 1) * stack.cell_mm.x, 0.0}),
                         y = std::max({row * stack.cell_mm.y - p.y, p.y - (row + 1) * stack.cell_mm.y, 0.0});
            nearest = std::min(nearest, std::max(x, y));
        }
    return nearest;
}

struct TopSheet {
    const SheetStack& stack;
    [[nodiscard]] double to_cavity(Vec2d p) const {
        return distance_to(stack, p, [&](int row, int column) {
            return row >= 0 && column >= 0 && row < stack.rows() && column < stack.columns() &&
                   stack.kept(row, column) > stack.missing(row, column) &&
                   stack.kept(row, column) < stack.count;
        });
    }
    [[nodiscard]] double to_edge(Vec2d p) const {
        const Vec2d size = stack.size_mm();
        if (p.x < 0 || p.y < 0 || p.x > size.x || p.y > size.y) return 0;
        return distance_to(stack, p, [&](int row, int column) {
            return row < 0 || column < 0 || row >= stack.rows() || column >= stack.columns() ||
                   !stack.has(row, column, stack.count - 1);
        });
    }
    [[nodiscard]] bool wants_slit(Vec2d p, double away) const {
        return std::abs(to_cavity(p) - away) < 1e-6 && to_edge(p) > 5 + kNear;
    }
};

bool lies_on(Vec2d p, const std::vector<std::vector<Vec2d>>& lines) {
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec2d a = line[i - 1], b = line[i];
            if (p.x > std::min(a.x, b.x) - kNear && p.x < std::max(a.x, b.x) + kNear &&
                p.y > std::min(a.y, b.y) - kNear && p.y < std::max(a.y, b.y) + kNear)
                return true;
        }
    return false;
}

void expect_right(const TopSheet& sheet, const std::vector<std::vector<Vec2d>>& slits, double away) {
    for (const auto& line : slits)
        for (std::size_t i = 1; i < line.size(); ++i)
            for (const double share : {0.0, 0.31, 0.77, 1.0}) {
                const Vec2d p = line[i - 1] + (line[i] - line[i - 1]) * share;
                EXPECT_NEAR(sheet.to_cavity(p), away, kNear);
                EXPECT_GT(sheet.to_edge(p), 5 - kNear);
            }
    // Beside the middle of each cell's sides, where a straight stretch has room.
    const Vec2d cell = sheet.stack.cell_mm;
    for (int row = 0; row < sheet.stack.rows(); ++row)
        for (int column = 0; column < sheet.stack.columns(); ++column)
            for (const Vec2d way : {Vec2d{1, 0}, Vec2d{-1, 0}, Vec2d{0, 1}, Vec2d{0, -1}}) {
                const Vec2d middle{(column + 0.5) * cell.x, (row + 0.5) * cell.y},
                    p = middle + Vec2d{way.x * (cell.x / 2 + away), way.y * (cell.y / 2 + away)},
                    along{way.y * 7.6, way.x * 7.6};
                if (sheet.wants_slit(p, away) && sheet.wants_slit(p + along, away) &&
                    sheet.wants_slit(p - along, away)) {
                    EXPECT_TRUE(lies_on(p, slits)) << row << " " << column;
                }
            }
}

/// Every slit is cut into exactly one piece, where it was.
void expect_each_on_one_piece(const SheetStack& stack, const std::vector<std::vector<Vec2d>>& slits) {
    std::vector<std::vector<Vec2d>> found;
    for (const SheetPiece& piece : stack.pieces)
        for (auto line : cut_piece(stack, piece, {}, {}, {}, slits).slit) {
            for (Vec2d& p : line) p = p + Vec2d{piece.column * stack.cell_mm.x, piece.row * stack.cell_mm.y};
            found.push_back(std::move(line));
        }
    ASSERT_EQ(found.size(), slits.size());
    for (const auto& line : found) EXPECT_TRUE(lies_on(line.front(), slits));
}

TEST(LinerSlits, RunAroundCavitiesAsFarAsFoamHasRoom) {
    const int cases = test::cases(200, 40);
    int lines = 0;
    for (int seed = 0; seed < cases; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 91000);
        const CutFoams foam = random.chance(0.3) ? test::l_shaped_foam() : test::random_sheet_foam(random);
        const double away = random.between(10, 30);
        for (const Half half : {Half::lower, Half::lid}) {
            const auto stack = sheet_stack(foam.design(), Piece(half), {foam.space.block_mm.x, 1, 1});
            if (!stack) continue;
            const auto slits = liner_slits(*stack, away);
            expect_right({*stack}, slits, away);
            expect_each_on_one_piece(*stack, slits);
            lines += static_cast<int>(slits.size());
        }
    }
    EXPECT_GT(lines, cases / 2);
}

struct IndexRow {
    std::string half;
    int sheet, stock;
};

/// piece,half,sheet,stock,...
std::vector<IndexRow> index_of(const WorkshopPack& pack) {
    std::istringstream lines(test::text_of(pack, "sheets/index.csv"));
    std::vector<IndexRow> rows;
    std::string line, piece, half, sheet, stock;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::getline(words, piece, ',');
        std::getline(words, half, ',');
        std::getline(words, sheet, ',');
        std::getline(words, stock, ',');
        rows.push_back({half, std::stoi(sheet), std::stoi(stock)});
    }
    return rows;
}

TEST(SecondColor, HasSheetsOfItsOwn) {
    int colors = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed + 92000);
        const CutFoams foam = test::random_sheet_foam(random);
        SheetOptions options;
        options.second_color = true;
        options.stock_mm = {600, 500};
        const auto pack = sheets_pack(foam.design(), options);
        if (!pack) continue;
        std::map<std::string, int> uppermost;
        std::vector<IndexRow> rows = index_of(*pack);
        for (const IndexRow& row : rows) uppermost[row.half] = std::max(uppermost[row.half], row.sheet);
        int first_color = 0, others = 1 << 30;
        for (const IndexRow& row : rows)
            if (row.sheet == uppermost[row.half])
                first_color = std::max(first_color, row.stock);
            else
                others = std::min(others, row.stock);
        EXPECT_LT(first_color, others);
        colors += others < 1 << 30;
    }
    EXPECT_GT(colors, 10);
}

}  // namespace
}  // namespace snug
