#include "snug/drawing/text_lines.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/base/utf8.h"

namespace snug::test {
namespace {

using Lines = std::vector<std::string>;

constexpr double kHeight = 3;

TEST(TextLines, EnglishBreaksAtSpacesAndLosesNone) {
    EXPECT_EQ(lines_of("look at it", 1000, kHeight), (Lines{"look at it"}));
    EXPECT_EQ(lines_of("look at it", text_width("look at", kHeight), kHeight), (Lines{"look at", "it"}));
    EXPECT_EQ(lines_of("wwwww", text_width("www", kHeight), kHeight), (Lines{"www", "ww"}));
    EXPECT_EQ(lines_of("", 10, kHeight), (Lines{""}));
}

TEST(TextLines, WideCharactersAreAsWideAsTheyAreHigh) {
    EXPECT_DOUBLE_EQ(text_width("緩衝材", kHeight), 3 * kHeight);
    EXPECT_DOUBLE_EQ(text_width("緩衝材 x", kHeight), 3 * kHeight + text_width(" x", kHeight));
}

TEST(TextLines, JapaneseBreaksBetweenItsCharactersButNotBeforeAMarkThatCloses) {
    EXPECT_EQ(lines_of("下のフォーム", 4 * kHeight, kHeight), (Lines{"下の", "フォーム"}));
    EXPECT_EQ(lines_of("対象物です。次", 5 * kHeight, kHeight), (Lines{"対象物で", "す。次"}));
    EXPECT_EQ(lines_of("上（下）", 3 * kHeight, kHeight), (Lines{"上", "（下）"}));
    EXPECT_EQ(lines_of("厚さ 25 mm のシート", 8 * kHeight, kHeight), (Lines{"厚さ 25 mm の", "シート"}));
}

TEST(TextLines, NoLineIsWiderThanAskedForNorBreaksACharacter) {
    const std::string text =
        "この図を原寸（100 "
        "%）で印刷し、点線で切り、ブロックの上に置いて、番号のあるブロックを抜いてください。"
        "Figure: vase-1.stl ですが、長い名前 a-very-long-name-without-any-blank.stl もあります。";
    for (double width = 8; width < 120; width += 3.7) {
        std::string joined;
        for (const std::string& line : lines_of(text, width, kHeight)) {
            EXPECT_TRUE(is_utf8(line));
            EXPECT_LE(text_width(line, kHeight), width + 1e-9);
            joined += line;
        }
        std::string without, expected;
        for (const char c : joined)
            if (c != ' ') without += c;
        for (const char c : text)
            if (c != ' ') expected += c;
        EXPECT_EQ(without, expected) << "nothing is lost";
    }
}

}  // namespace
}  // namespace snug::test
