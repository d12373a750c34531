#include "snug/formats/xml_read.h"

#include <string>

#include <gtest/gtest.h>

#include "snug/base/utf8.h"
#include "snug/words/words.h"

#include "tests/support/random.h"
#include "tests/support/read_checks.h"

namespace snug::test {
namespace {

/// The elements, as "<namespace|name a='1'>" and "</>", or the sentence that says what is wrong.
std::string told(std::string_view document, const std::vector<std::string>& attributes = {}) {
    XmlReader xml(bytes_of(document));
    std::string text;
    for (;;) {
        const auto event = xml.next();
        if (!event) return snug::text(event.error().message);
        if (*event == XmlEvent::done) return text;
        if (*event == XmlEvent::end) {
            text += "</>";
            continue;
        }
        text += "<" + std::string(xml.space()) + "|" + std::string(xml.name());
        for (const std::string& name : attributes)
            if (const auto value = xml.attribute(name)) text += " " + name + "='" + std::string(*value) + "'";
        text += ">";
    }
}

TEST(XmlRead, ElementsAreToldWithTheirNamespaces) {
    EXPECT_EQ(told("<a xmlns='u'><b/><p:c xmlns:p=\"v\"><d></d></p:c><p:e/></a>"),
              "<u|a><u|b></><v|c><u|d></></><|e></></>");
    EXPECT_EQ(told("<p:a xmlns:p='u'><b xmlns='w' xmlns:p='x'><p:c/></b><p:d/></p:a>"),
              "<u|a><w|b><x|c></></><u|d></></>");
}

TEST(XmlRead, AttributesStandInEitherQuotesWithEntities) {
    EXPECT_EQ(told("<a b = 'x\"y' c=\"x'y\"\n\td='&lt;&#65;&#x42;&amp;amp;' e='&what;' f='1&'/>",
                   {"b", "c", "d", "e", "f", "g"}),
              "<|a b='x\"y' c='x'y' d='<AB&amp;'></>");
    XmlReader xml(
        bytes_of("<a b='plain' p:b='own' q:b='other' xmlns:p='http://p/2020' xmlns:q='http://q/'/>"));
    ASSERT_TRUE(xml.next());
    EXPECT_EQ(xml.attribute("b"), "plain");
    EXPECT_EQ(xml.attribute("http://p/", "b"), "own");
    EXPECT_EQ(xml.attribute("http://r/", "b"), std::nullopt);
}

TEST(XmlRead, WhatIsNoElementIsPassedOver) {
    EXPECT_EQ(told("<?xml version='1.0' encoding='utf-8'?>\n<!-- <no/> > -- -->"
                   "<!DOCTYPE a [ <!ENTITY b \"]><c/>\"> <!-- ]> --> ] ><a>text &amp; &what; "
                   "<![CDATA[<not><this>]]><?php <nor this> ?><b/> more</a><!-- end -->\n"),
              "<|a><|b></></>");
}

TEST(XmlRead, EveryEncodingOfPackagesIsTheSame) {
    const std::string plain = "<?xml version=\"1.0\"?><\u00e4 b='\u732b\U0001F408'/>";
    const std::string expected = "<|\u00e4 b='\u732b\U0001F408'></>";
    EXPECT_EQ(told(plain, {"b"}), expected);
    EXPECT_EQ(told("\xef\xbb\xbf" + plain, {"b"}), expected);
    for (const bool marked : {true, false}) {
        for (const bool big : {true, false}) {
            std::string utf16;
            const auto put = [&](char16_t unit) {
                const char low = static_cast<char>(unit & 0xff), high = static_cast<char>(unit >> 8);
                utf16 += big ? high : low;
                utf16 += big ? low : high;
            };
            if (marked) put(0xfeff);
            for (const char16_t unit :
                 std::u16string_view(u"<?xml version=\"1.0\"?><\u00e4 b='\u732b\U0001F408'/>"))
                put(unit);
            EXPECT_EQ(told(utf16, {"b"}), expected) << marked << big;
        }
    }
}

TEST(XmlRead, SkippingEndsBehindTheElement) {
    XmlReader xml(bytes_of("<a><b><c><b/></c>x</b><d/></a>"));
    ASSERT_TRUE(xml.next());
    ASSERT_TRUE(xml.next());
    EXPECT_EQ(xml.name(), "b");
    ASSERT_TRUE(xml.skip());
    ASSERT_EQ(xml.next(), XmlEvent::start);
    EXPECT_EQ(xml.name(), "d");
    ASSERT_TRUE(xml.skip());
    EXPECT_EQ(xml.next(), XmlEvent::end);
    EXPECT_EQ(xml.next(), XmlEvent::done);
}

TEST(XmlRead, DamageIsNamedWithItsLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"", "no element"},
        {"plain text", "no element"},
        {"<a>\n<b>", "line 2: it is cut off within the element \"b\""},
        {"<a>\n\n</b>", "line 3: there is the end of an element \"b\", where that of \"a\" is due"},
        {"</a>", "there is the end of an element \"a\""},
        {"<a/><b/>", "second element"},
        {"<a b>", "damaged or cut off"},
        {"<a b='1", "no quotes"},
        {"<a b=1/>", "no quotes"},
        {"<a", "damaged or cut off"},
        {"< a/>", "no name"},
        {"<a><!-- </a>", "cut off within a comment"},
        {"<!DOCTYPE a [ <!ENTITY b 'c'> ", "cut off within a comment"},
    };
    for (const auto& [document, words] : wrong) expect_holds(told(document), words);
}

TEST(XmlRead, NestingAttributesAndNamespacesHaveLimits) {
    std::string deep, wide = "<a", spaces = "<a";
    for (int i = 0; i < 300; ++i) deep += "<a>";
    for (int i = 0; i < 1100; ++i) wide += " b" + std::to_string(i) + "=''";
    for (int i = 0; i < 300; ++i) spaces += " xmlns:b" + std::to_string(i) + "=''";
    expect_holds(told(deep), "more than 256 deep");
    expect_holds(told(wide + "/>"), "more than 1024 attributes");
    expect_holds(told(spaces + "/>"), "more than 256 namespaces");
}

/// Whatever the bytes are, the reader ends, and every start has its end.
TEST(XmlRead, RandomDocumentsEndInOrder) {
    constexpr std::string_view kPieces[] = {
        "<a", "<p:b",      ">",   "/>", "</a>", "</p:b>", " c='1'", "<!--", "-->", "&lt;",       "<?x",
        "?>", "<![CDATA[", "]]>", "\"", "'",    " ",      "<!",     "[",    "]",   "xmlns:p='u'"};
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
        Random random(seed);
        std::string document;
        for (int i = random.integer(0, 30); i > 0; --i)
            document += kPieces[random.bits() % std::size(kPieces)];
        XmlReader xml(bytes_of(document));
        int depth = 0;
        for (std::size_t step = 0; step <= 2 * document.size() + 2; ++step) {
            ASSERT_LE(step, 2 * document.size() + 1) << "seed " << seed;
            const auto event = xml.next();
            if (!event || *event == XmlEvent::done) break;
            depth += *event == XmlEvent::start ? 1 : -1;
            ASSERT_GE(depth, 0) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace snug::test
