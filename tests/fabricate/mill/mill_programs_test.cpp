#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/fabricate/mill/gcode.h"
#include "snug/fabricate/mill/mill.h"
#include "snug/fabricate/mill/mill_plan.h"
#include "snug/formats/read.h"
#include "snug/make.h"
#include "snug/samples/samples.h"
#include "snug/words/words.h"

#include "tests/support/gcode_stock.h"
#include "tests/support/milled.h"
#include "tests/support/models.h"
#include "tests/support/print_design.h"

// What the programs say and how the halves lie on their pins.

namespace snug {
namespace {

using test::GcodeMove;
using test::GcodeProgram;
using test::height_of;
using test::Random;
using test::text_of;

/// No byte that GRBL or what sends to it takes for anything but text, and lines that it has room for.
void expect_harmless(const std::string& text) {
    for (const char c : text) {
        const bool printable = c >= 32 && c < 127;
        ASSERT_TRUE(c == '\n' ||
                    (printable && std::string("!~?%;$\\\"[]{}<>^`|*#@").find(c) == std::string::npos))
            << static_cast<int>(c);
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        ASSERT_LT(line.size(), 80u) << line;
        const auto brackets =
            std::count_if(line.begin(), line.end(), [](char c) { return c == '(' || c == ')'; });
        ASSERT_TRUE(brackets == 0 || (brackets == 2 && line.front() == '(' && line.back() == ')')) << line;
    }
}

/// The board's holes are where the half has its own once it is turned over about x.
void expect_board_takes(const std::string& board_program, const MillPlan& half, Vec2d zero = {}) {
    const GcodeProgram board = test::read_gcode(board_program);
    for (const std::string& problem : board.problems) ADD_FAILURE() << problem;
    ASSERT_EQ(half.pins.size(), 2u);
    for (const MillPin& pin : half.pins)
        EXPECT_TRUE(std::any_of(board.moves.begin(), board.moves.end(), [&](const GcodeMove& move) {
            return !move.rapid && std::abs(move.to.x + zero.x - pin.at.x) < 1e-3 &&
                   std::abs(move.to.y + zero.y - (half.field.size_mm().y - pin.at.y)) < 1e-3;
        }));
}

/// All of 4 x 8 x 10 blocks but some of column A1.
Grid<snug::Run> without_corner(snug::Run left) {
    Grid<snug::Run> available(8, 10, {0, 4});
    available(0, 0) = left;
    return available;
}

TEST(MillTest, WhatACaseLeavesOutIsMilledFromOutsideOnTheSamePins) {
    test::Heights lower = test::filled(8, 10, 2);
    lower(4, 4) = 1;
    test::PrintDesign design({{4, 8, 10}, {10, 10, 10}}, lower, test::filled(8, 10, 2));
    design.shorten(without_corner({1, 4}));  // BACK, left
    MillOptions options;
    options.pin_mm = 6;
    const auto plans = mill_plans(design.view(), {}, options);
    ASSERT_TRUE(plans) << snug::text(plans.error().message);
    ASSERT_EQ(plans->plans.size(), 3u);
    const MillPlan& outside = plans->plans[2];
    EXPECT_EQ(outside.piece.half(), Half::lower);
    // BACK is far in the lower half; turned over about x it comes near, and left stays left.
    EXPECT_EQ(outside.field.height(0, 0), outside.field.top - outside.field.steps_a_block);
    EXPECT_EQ(std::count(outside.field.height.begin(), outside.field.height.end(), outside.field.top), 79);
    const auto pack = mill_pack(design.view(), {}, options);
    ASSERT_TRUE(pack);
    EXPECT_FALSE(text_of(*pack, "mill/lower-outside.nc").empty());
    EXPECT_TRUE(text_of(*pack, "mill/lid-outside.nc").empty());
    EXPECT_TRUE(text_of(*pack, "mill/lid-board.nc").empty());
    expect_board_takes(text_of(*pack, "mill/lower-board.nc"), plans->plans[0]);
}

TEST(MillTest, EachTurnedHalfLiesOnItsOwnHolesInTheBoard) {
    test::PrintDesign design({{4, 8, 10}, {10, 10, 10}}, test::filled(8, 10, 2), test::filled(8, 10, 2));
    design.shorten(without_corner({1, 3}));
    for (const MillOrigin origin : {MillOrigin::corner, MillOrigin::centre}) {
        MillOptions options;
        options.origin = origin;
        const auto plans = mill_plans(design.view(), {}, options);
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        const auto pack = mill_pack(design.view(), {}, options);
        ASSERT_TRUE(pack);
        const Vec2d zero = origin == MillOrigin::centre ? Vec2d{50, 40} : Vec2d{};
        expect_board_takes(text_of(*pack, "mill/lower-board.nc"), plans->plans[0], zero);
        expect_board_takes(text_of(*pack, "mill/lid-board.nc"), plans->plans[1], zero);
    }
}

TEST(MillTest, EveryProgramSaysWhichSideIsUpWhereBackIsAndWhereZeroIs) {
    test::Heights half = test::filled(8, 10, 2);
    half(4, 4) = 1;
    test::PrintDesign design({{4, 8, 10}, {10, 10, 10}}, half, half);
    design.shorten(without_corner({1, 3}));
    const auto pack = mill_pack(design.view(), {}, {});
    ASSERT_TRUE(pack);
    struct Said {
        const char *file, *up, *back, *zero;
    };
    const char* const corner = "(X0 Y0 at the near left corner of the stock, Z0 on its top)";
    const char* const board = "(X0 Y0 at the near left corner of where the stock will lie, Z0 on the board)";
    const std::vector<Said> all{
        {"lower.nc", "(LOWER, cavity up. Object: L & co)", "(BACK away from you)", corner},
        {"lid.nc", "(LID, cavity up. Object: L & co)", "(BACK towards you)", corner},
        {"lower-outside.nc", "(LOWER, outer side up, cavity down. Object: L & co)", "(BACK towards you)",
         corner},
        {"lid-outside.nc", "(LID, outer side up, cavity down. Object: L & co)", "(BACK away from you)",
         corner},
        {"lower-board.nc", "(BOARD below LOWER. Object: L & co)", "cavity down, BACK towards you)", board},
        {"lid-board.nc", "(BOARD below LID. Object: L & co)", "cavity down, BACK away from you)", board}};
    EXPECT_EQ(pack->files.size(), all.size());
    for (const Said& said : all) {
        std::string text = text_of(*pack, std::string("mill/") + said.file);
        expect_harmless(text);
        // Long remarks go on in the next comment.
        for (std::size_t at; (at = text.find(")\n(")) != std::string::npos;) text.replace(at, 3, " ");
        text = text.substr(0, text.find('\n'));
        for (const char* words : {said.up, said.back, said.zero}) {
            std::string bare = words;
            bare.erase(std::remove_if(bare.begin(), bare.end(), [](char c) { return c == '(' || c == ')'; }),
                       bare.end());
            EXPECT_NE(text.find(bare), std::string::npos) << said.file << ": " << bare << " in " << text;
        }
        EXPECT_EQ(text.find("cavity up") == std::string::npos,
                  std::string(said.file).find('-') != std::string::npos)
            << text;
    }
}

TEST(MillTest, PinsFitOneWayAndMeetInBothHalves) {
    Random random(4);
    int with_pins = 0;
    for (int i = 0; i < 30; ++i) {
        const DesignSpace space{{4, random.integer(5, 12), random.integer(5, 12)}, {12, 10, 10}};
        test::Heights lower = test::filled(space.blocks.y, space.blocks.z, 2), upper = lower;
        for (int n = 0; n < 4; ++n) {
            lower(random.integer(1, space.blocks.y - 2), random.integer(1, space.blocks.z - 2)) = 0;
            upper(random.integer(0, space.blocks.y - 1), random.integer(0, space.blocks.z - 1)) = 1;
        }
        const test::PrintDesign design(space, lower, upper);
        const auto plans = mill_plans(design.view(), {}, {});
        ASSERT_TRUE(plans) << snug::text(plans.error().message);
        const auto &own = plans->plans[0].pins, &other = plans->plans[1].pins;
        ASSERT_EQ(own.size(), other.size());
        if (own.empty()) continue;
        ++with_pins;
        const Vec2d size = plans->plans[0].field.size_mm();
        for (std::size_t pin = 0; pin < own.size(); ++pin) {
            EXPECT_NEAR(own[pin].at.x, other[pin].at.x, 1e-9);
            EXPECT_NEAR(own[pin].at.y, size.y - other[pin].at.y, 1e-9);
            for (const double dx : {-6.0, 0.0, 6.0})
                for (const double dy : {-6.0, 0.0, 6.0}) {
                    EXPECT_EQ(height_of(plans->plans[0].field, own[pin].at + Vec2d{dx, dy}), 24);
                    EXPECT_EQ(height_of(plans->plans[1].field, other[pin].at + Vec2d{dx, dy}), 24);
                }
        }
        const Vec2d turned = size - own[0].at;
        EXPECT_GE(length(turned - own[1].at), 9);
    }
    EXPECT_GT(with_pins, 15);
}

TEST(MillTest, WhatTheCutterCannotDoIsSaidWithWhatWouldWork) {
    test::Heights lower = test::filled(9, 9, 3);
    lower(4, 4) = 0;
    const test::PrintDesign design({{4, 9, 9}, {10, 10, 10}}, lower, test::filled(9, 9, 1));
    MillOptions options;
    options.cutter_mm = 12;
    auto refused = mill_pack(design.view(), {}, options);
    ASSERT_FALSE(refused);
    EXPECT_NE(snug::text(refused.error().message).find("10 mm"), std::string::npos)
        << snug::text(refused.error().message);
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
    options.cutter_mm = 10;
    options.flute_mm = 29;
    refused = mill_pack(design.view(), {}, options);
    ASSERT_FALSE(refused);
    EXPECT_NE(snug::text(refused.error().message).find("at least 30 mm"), std::string::npos)
        << snug::text(refused.error().message);
    options.flute_mm = 30;
    EXPECT_TRUE(mill_pack(design.view(), {}, options));
    options.feed_mm_min = 0;
    EXPECT_FALSE(mill_pack(design.view(), {}, options));
}

TEST(MillTest, FlatHalvesNeedNoProgram) {
    const test::PrintDesign design({{4, 9, 9}, {10, 10, 10}}, test::filled(9, 9, 2), test::filled(9, 9, 2));
    MillOptions options;
    options.pin_mm = 0;
    const auto pack = mill_pack(design.view(), {}, options);
    ASSERT_TRUE(pack);
    EXPECT_TRUE(pack->files.empty());
    EXPECT_EQ(pack->findings.front().code(), "nothing_to_mill");
}

/// Names of any bytes, most of them of those that do harm.
std::string hostile_name(Random& random) {
    static const std::vector<std::string> parts{"!",
                                                "~",
                                                "?",
                                                "%",
                                                ";",
                                                "(",
                                                ")",
                                                "$X",
                                                "\n",
                                                "\r",
                                                "\t",
                                                "\x18",
                                                "\x7f",
                                                "\x84",
                                                "\x85",
                                                "\xff",
                                                "\xe5\xa3\xba",
                                                "\xc3\xa4",
                                                "\xf0\x9f\x8f\xba",
                                                "\xe2\x80\xa8",
                                                "M3 S9",
                                                "G0 Z-50",
                                                " ",
                                                "vase",
                                                "L",
                                                "\xc3",
                                                "\xcc\x88",
                                                "*",
                                                "[",
                                                "/"};
    std::string name;
    for (int i = random.integer(0, 60); i > 0; --i)
        name += random.chance(0.8)
                    ? parts[static_cast<std::size_t>(random.integer(0, static_cast<int>(parts.size()) - 1))]
                    : std::string(1, static_cast<char>(random.integer(0, 255)));
    return name;
}

TEST(MillTest, NoNameStopsOrStartsTheMachine) {
    Random random(17);
    for (int i = 0; i < 3000; ++i) {
        const std::string name = hostile_name(random);
        SCOPED_TRACE("case " + std::to_string(i));
        const std::string text =
            grbl_program({}, {10, 10}, {}, {"LID, outer side up, cavity down", name}, {name, "BACK " + name});
        expect_harmless(text);
        EXPECT_EQ(text.rfind("(LID, outer side up, cavity down", 0), 0u) << text;
        const GcodeProgram program = test::read_gcode(text);
        EXPECT_TRUE(program.problems.empty());
        EXPECT_TRUE(program.moves.empty());
        EXPECT_TRUE(program.ended);
    }
}

TEST(MillTest, ALongNameIsShortenedAndTheWordsAreNot) {
    const auto first_line = [](const std::string& name) {
        const std::string text = grbl_program({}, {10, 10}, {}, {"LOWER, cavity up", name}, {});
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(first_line("fragile! ~ keep"), "(LOWER, cavity up. Object: fragile keep)");
    EXPECT_EQ(first_line("M\xc3\xbcller \xe5\xa3\xba\xe5\xa3\xba 2"),
              "(LOWER, cavity up. Object: Muller _ 2)");
    EXPECT_EQ(first_line("!?"), "(LOWER, cavity up)");
    const std::string line = first_line(std::string(500, 'x'));
    EXPECT_EQ(line.size(), 72u);
    EXPECT_EQ(line.substr(0, 30), "(LOWER, cavity up. Object: xxx");
    EXPECT_EQ(line.substr(68), "...)");
}

}  // namespace
}  // namespace snug
