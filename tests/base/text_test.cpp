#include "snug/base/text.h"

#include <gtest/gtest.h>

namespace snug {
namespace {

TEST(Text, WhatIsQuotedKeepsItsLettersAndNothingThatMovesTheCursor) {
    EXPECT_EQ(quoted("壺 ä"), "\"壺 ä\"");
    EXPECT_EQ(quoted("a\nb\x1b[2J"), "\"a b [2J\"");
    EXPECT_EQ(quoted("a\xE2\x80\xAE"
                     "b"),
              "\"ab\"");
    EXPECT_EQ(quoted("a\xFF"), "\"a\xEF\xBF\xBD\"");
}

TEST(Text, WhatIsQuotedEndsBehindAWholeCharacter) {
    EXPECT_EQ(quoted("壺壺", 6), "\"壺壺\"");
    EXPECT_EQ(quoted("壺壺壺", 6), "\"壺壺...\"");
    EXPECT_EQ(quoted("壺壺", 5), "\"壺...\"");
    EXPECT_EQ(quoted("壺壺", 4), "\"壺...\"");
    EXPECT_EQ(quoted("abc", 2), "\"ab...\"");
    EXPECT_EQ(quoted("\x80\x80\x80\x80\x80", 4).substr(0, 4), "\"\xEF\xBF\xBD");
}

}  // namespace
}  // namespace snug
