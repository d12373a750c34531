#include "snug/fabricate/sheets/nesting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/cases.h"
#include "tests/support/random.h"

namespace snug {
namespace {

Mask full(int width, int height) {
    Mask mask(width, height);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) mask.set(column, row);
    return mask;
}

/// Lengths with decimals that no binary number has: their sums must still come out even.
TEST(Nesting, WhatFillsTheStockExactlyFits) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        const auto tenths = [&](int low, int high) { return random.integer(low, high) / 10.0; };
        SheetOptions options;
        options.kerf_mm = tenths(0, 5);
        options.spacing_mm = tenths(0, 40);
        options.margin_mm = tenths(0, 100);
        const Vec2d cell{tenths(51, 300), tenths(51, 300)};
        const int across = random.integer(1, 9), down = random.integer(1, 9);
        const Mask mask = full(random.integer(1, 4), random.integer(1, 4));
        const double gap = options.spacing_mm + options.kerf_mm, border = options.margin_mm + options.kerf_mm;
        options.stock_mm = {across * (mask.width * cell.x + gap) - gap + 2 * border,
                            down * (mask.height * cell.y + gap) - gap + 2 * border};
        const std::vector<PieceToNest> pieces(static_cast<std::size_t>(across * down),
                                              {"piece", &mask, mask.width * mask.height});
        const auto nesting = nest(pieces, cell, options);
        ASSERT_TRUE(nesting);
        EXPECT_EQ(nesting->stocks, 1);
    }
}

TEST(Nesting, CutsKeepTheSpacingAndTheMargin) {
    constexpr double kRounding = 1e-6;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        SheetOptions options;
        options.stock_mm = {random.between(300, 1000), random.between(300, 1000)};
        options.kerf_mm = random.between(0, 1);
        options.spacing_mm = random.between(0, 10);
        options.margin_mm = random.between(0, 20);
        const Vec2d cell{random.between(5, 30), random.between(5, 30)};
        std::vector<Mask> masks;
        for (int i = random.integer(1, 40); i > 0; --i)
            masks.push_back(full(random.integer(1, 8), random.integer(1, 8)));
        std::vector<PieceToNest> pieces;
        for (const Mask& mask : masks)
            pieces.push_back({"piece", &mask, mask.width * mask.height, random.integer(0, 1)});
        const auto nesting = nest(pieces, cell, options, false);
        ASSERT_TRUE(nesting);
        for (std::size_t i = 0; i < pieces.size(); ++i)
            EXPECT_EQ(nesting->places[i].stock < nesting->first_color_stocks, pieces[i].color == 0);
        const double gap = options.spacing_mm + options.kerf_mm, border = options.margin_mm + options.kerf_mm;
        const auto end = [&](std::size_t i) {
            return nesting->places[i].corner + Vec2d{masks[i].width * cell.x, masks[i].height * cell.y};
        };
        for (std::size_t i = 0; i < masks.size(); ++i) {
            const Vec2d corner = nesting->places[i].corner;
            EXPECT_GE(std::min(corner.x, corner.y), border - kRounding);
            EXPECT_LE(end(i).x, nesting->stock_mm.x - border + kRounding);
            EXPECT_LE(end(i).y, nesting->stock_mm.y - border + kRounding);
            for (std::size_t j = 0; j < i; ++j) {
                const PiecePlace &a = nesting->places[i], &b = nesting->places[j];
                if (a.stock != b.stock) continue;
                EXPECT_TRUE(
                    end(i).x + gap <= b.corner.x + kRounding || end(j).x + gap <= a.corner.x + kRounding ||
                    end(i).y + gap <= b.corner.y + kRounding || end(j).y + gap <= a.corner.y + kRounding);
            }
        }
    }
}

/// Connected at random: as sheets of foam are, with notches and holes.
Mask random_shape(test::Random& random) {
    Mask mask = full(random.integer(1, 12), random.integer(1, 12));
    for (int i = random.integer(0, 3); i > 0; --i) {
        const int column = random.integer(0, mask.width - 1), row = random.integer(0, mask.height - 1);
        for (int y = row; y < std::min(mask.height, row + random.integer(1, 8)); ++y)
            for (int x = column; x < std::min(mask.width, column + random.integer(1, 8)); ++x)
                mask.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                           static_cast<std::size_t>(x)] = 0;
    }
    mask.set(0, 0);
    return mask;
}

struct Cells {
    const Mask* mask;
    Vec2d corner, cell;
    [[nodiscard]] Vec2d at(int column, int row) const {
        return corner + Vec2d{column * cell.x, row * cell.y};
    }
};

/// The least distance along x or y, whichever is larger, between cells of two pieces.
double least_distance(const Cells& a, const Cells& b) {
    double least = 1e9;
    for (int row = 0; row < a.mask->height; ++row)
        for (int column = 0; column < a.mask->width; ++column) {
            if (!a.mask->contains(column, row)) continue;
            const Vec2d p = a.at(column, row);
            for (int y = 0; y < b.mask->height; ++y)
                for (int x = 0; x < b.mask->width; ++x) {
                    if (!b.mask->contains(x, y)) continue;
                    const Vec2d q = b.at(x, y);
                    least = std::min(
                        least, std::max(std::fabs(p.x - q.x) - a.cell.x, std::fabs(p.y - q.y) - a.cell.y));
                }
        }
    return least;
}

TEST(Nesting, CellsKeepTheSpacingAndNoMoreStockIsTakenThanByBoxes) {
    int fewer = 0, less = 0;
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::cases(30, 6)); ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed + 500);
        SheetOptions options;
        options.stock_mm = {random.between(300, 600), random.between(300, 600)};
        options.kerf_mm = random.between(0, 1);
        options.spacing_mm = random.chance(0.2) ? 0 : random.between(0, 10);
        options.margin_mm = random.between(0, 20);
        const Vec2d cell{random.between(8, 22), random.between(8, 22)};
        std::vector<Mask> masks;
        for (int i = random.integer(1, 25); i > 0; --i) masks.push_back(random_shape(random));
        std::vector<PieceToNest> pieces;
        for (const Mask& mask : masks)
            pieces.push_back({"piece", &mask,
                              static_cast<int>(std::count(mask.cells.begin(), mask.cells.end(), 1)),
                              random.integer(0, 4) / 4});
        const auto boxes = nest(pieces, cell, options, false), nesting = nest(pieces, cell, options);
        ASSERT_EQ(boxes.has_value(), nesting.has_value());
        if (!nesting) continue;
        EXPECT_LE(nesting->stocks, boxes->stocks);
        fewer += nesting->stocks < boxes->stocks;
        less += nesting->used_mm2 < boxes->used_mm2 - 1;
        const double gap = options.spacing_mm + options.kerf_mm, border = options.margin_mm + options.kerf_mm;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const PiecePlace& place = nesting->places[i];
            EXPECT_EQ(place.stock < nesting->first_color_stocks, pieces[i].color == 0);
            EXPECT_LT(place.stock, nesting->stocks);
            const Cells one{&masks[i], place.corner, cell};
            const Vec2d end = one.at(masks[i].width, masks[i].height);
            EXPECT_GE(std::min(place.corner.x, place.corner.y), border - 1e-6);
            EXPECT_LE(end.x, nesting->stock_mm.x - border + 1e-6);
            EXPECT_LE(end.y, nesting->stock_mm.y - border + 1e-6);
            for (std::size_t k = 0; k < i; ++k)
                if (nesting->places[k].stock == place.stock) {
                    EXPECT_GE(least_distance(one, {&masks[k], nesting->places[k].corner, cell}), gap - 1e-6);
                }
            if (place.host >= 0) {
                EXPECT_EQ(nesting->places[static_cast<std::size_t>(place.host)].stock, place.stock);
            }
        }
    }
    EXPECT_GT(fewer + less, 0);
}

/// Two brackets that only go onto one sheet where each reaches into the other.
TEST(Nesting, NotchesReachIntoEachOther) {
    Mask bracket = full(6, 6);
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column)
            if (column >= 2 && row >= 2) bracket.cells[static_cast<std::size_t>(6 * row + column)] = 0;
    Mask other(6, 6);
    for (int row = 0; row < 6; ++row)
        for (int column = 0; column < 6; ++column)
            if (bracket.contains(5 - column, 5 - row)) other.set(column, row);
    SheetOptions options;
    options.margin_mm = 0;
    options.spacing_mm = 5;
    options.stock_mm = {90, 90};
    const std::vector<PieceToNest> pieces{{"one", &bracket, 20}, {"other", &other, 20}};
    const auto nesting = nest(pieces, {10, 10}, options);
    ASSERT_TRUE(nesting);
    EXPECT_EQ(nesting->stocks, 1);
    EXPECT_EQ(nest(pieces, {10, 10}, options, false)->stocks, 2);
}

}  // namespace
}  // namespace snug
