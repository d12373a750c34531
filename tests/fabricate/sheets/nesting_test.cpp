#include "snug/fabricate/sheets/nesting.h"

#include <vector>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace snug
