#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "snug/formats/text_scan.h"

#include "tests/support/random.h"

namespace snug {
namespace {

using test::Random;

/// The bits, so that both zeros differ.
std::uint64_t bits(double value) {
    std::uint64_t raw = 0;
    std::memcpy(&raw, &value, sizeof raw);
    return raw;
}

void expect_as_the_c_library_reads_it(const std::string& word) {
    double value = 0;
    ASSERT_TRUE(to_number(word, value)) << word;
    EXPECT_EQ(bits(value), bits(std::strtod(word.c_str(), nullptr))) << word;
}

std::string digits(Random& random, int count) {
    std::string text;
    for (; count > 0; --count) text += static_cast<char>('0' + random.integer(0, 9));
    return text;
}

TEST(ReadNumbers, EveryDecimalIsRoundedAsTheCLibraryDoes) {
    for (int seed = 0; seed < 200000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        std::string word = random.chance(0.5) ? "-" : "";
        word += digits(random, random.integer(1, 18));
        if (random.chance(0.8)) word.append(".").append(digits(random, random.integer(0, 18)));
        if (random.chance(0.1)) word.append("e").append(std::to_string(random.integer(-40, 40)));
        expect_as_the_c_library_reads_it(word);
    }
    for (const char* word :
         {"0", "-0", "0.0", "-0.000", "5.", "-5.", ".5", "-.5", "999999999999999", "9999999999999999",
          "0.123456789012345", "9007199254740993", "9007199254740993.0", "1e22", "1e23"})
        expect_as_the_c_library_reads_it(word);
}

TEST(ReadNumbers, WordsThatAreNoNumberAreRefused) {
    double value = 0;
    for (const char* word : {"",    "-",   "+",   ".",  "-.",  "1..2", "1.2.3", "1,5", "0x1",   "1-",  "--1",
                             "+-1", "-+1", "++1", "1 ", "nan", "inf",  "-inf",  "1e",  "1e999", "12a", "a12"})
        EXPECT_FALSE(to_number(word, value)) << word;
    EXPECT_TRUE(to_number("+1.5", value));
    EXPECT_EQ(value, 1.5);
}

}  // namespace
}  // namespace snug
