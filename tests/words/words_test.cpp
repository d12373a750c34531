#include "snug/words/words.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/words/catalogue.h"

namespace snug {
namespace {

std::vector<Message> named(const std::vector<std::string>& names) {
    std::vector<Message> messages;
    for (const std::string& name : names) messages.push_back(as_it_is(name));
    return messages;
}

TEST(Words, ACountChoosesTheWordInEnglishAlone) {
    const auto capped = [](int holes, Language language) {
        return text(say("capped", {{"holes", holes}}), language);
    };
    EXPECT_EQ(capped(1, Language::english),
              "1 hole was closed before cutting; where the surface is missing its shape is a guess");
    EXPECT_EQ(capped(1200, Language::english),
              "1,200 holes were closed before cutting; where the surface is missing its shape is a guess");
    EXPECT_EQ(capped(1, Language::japanese), "切る前に 1 個の穴をふさぎました。表面のない所の形は推定です。");
}

TEST(Words, AListIsJoinedAsItsPlaceSays) {
    const auto islands = [](const std::vector<std::string>& names, Language language) {
        return text(say("sheets.names", {{"names", named(names)}}), language);
    };
    EXPECT_EQ(islands({"L2a"}, Language::english), "L2a");
    EXPECT_EQ(islands({"L2a", "L2b", "U1a"}, Language::english), "L2a, L2b and U1a");
    EXPECT_EQ(islands({"L2a", "L2b", "U1a"}, Language::japanese), "L2a、L2bとU1a");
    const Message parts = say("parts", {{"parts", 2}, {"sizes", named({"1 x 2 x 3", "4 x 5 x 6"})}});
    EXPECT_EQ(text(parts), "the object has 2 separate parts (1 x 2 x 3; 4 x 5 x 6 mm)");
}

TEST(Words, AMessageStandsWithinAnotherInItsLanguage) {
    const Message bearing = say(
        "no_bearing", {{"foam", say("foam.lower")}, {"fills", std::vector<Message>{as_it_is("--pads 2")}}});
    EXPECT_EQ(text(bearing).substr(0, 39), "the lower foam does not hold the object");
    EXPECT_EQ(text(bearing, Language::japanese).substr(0, std::string("下の緩衝材が").size()),
              "下の緩衝材が");
}

TEST(Words, WhatIsNoMessageStaysAsItIs) {
    for (const Language language : {Language::english, Language::japanese})
        EXPECT_EQ(text(as_it_is("a {name} of 1,5"), language), "a {name} of 1,5");
}

TEST(Words, LanguagesAreKnownByTheirShortNames) {
    EXPECT_EQ(language_from_name("ja"), Language::japanese);
    EXPECT_EQ(language_from_name("en"), Language::english);
    EXPECT_FALSE(language_from_name("fr"));
    EXPECT_EQ(language_name(Language::japanese), "ja");
}

}  // namespace
}  // namespace snug
