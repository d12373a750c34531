#include "snug/base/utf8.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/read_checks.h"

namespace snug::test {
namespace {

/// Every character of Unicode is its own UTF-8 and comes back from UTF-16 of both orders.
TEST(Utf8, EveryCharacterComesBackFromUtf16) {
    std::string utf8, little("\xff\xfe", 2), big("\xfe\xff", 2);
    const auto put = [&](unsigned unit) {
        const char low = static_cast<char>(unit & 0xff), high = static_cast<char>(unit >> 8);
        little += {low, high};
        big += {high, low};
    };
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        if (c >= 0xD800 && c < 0xE000) continue;
        append_utf8(c, utf8);
        if (c >= 0x10000) put(0xD800 + ((c - 0x10000) >> 10));
        put(c < 0x10000 ? c : 0xDC00 + (c & 0x3ff));
    }
    EXPECT_TRUE(is_utf8(utf8));
    EXPECT_TRUE(from_utf16(bytes_of(little)) == utf8);
    EXPECT_TRUE(from_utf16(bytes_of(big)) == utf8);
}

TEST(Utf8, WhatIsNoCharacterIsNot) {
    for (const char* wrong : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                              "\xf8\x88\x80\x80\x80", "a\xff"})
        EXPECT_FALSE(is_utf8(wrong)) << wrong;
    std::string text;
    append_utf8(0xD800, text);
    EXPECT_EQ(text, "\ufffd");
    EXPECT_EQ(from_utf16(bytes_of(std::string("\xff\xfe\x00\xd8\x41", 5))), "\ufffd\ufffd");
}

TEST(Utf8, TextOfOtherKindsIsNotTakenForUtf16) {
    EXPECT_FALSE(from_utf16(bytes_of("<model/>")));
    EXPECT_FALSE(from_utf16(bytes_of("\xef\xbb\xbf<")));
    EXPECT_FALSE(from_utf16({}));
    EXPECT_FALSE(from_utf16(bytes_of(std::string("\0\0\0\0", 4))));
    EXPECT_EQ(from_utf16(bytes_of(std::string("<\0/\0", 4))), "</");
    EXPECT_EQ(from_utf16(bytes_of(std::string("\0<\0/", 4))), "</");
}

}  // namespace
}  // namespace snug::test
