#include "cli/latin_text.h"

#include <algorithm>
#include <array>

#include "snug/base/wide_text.h"

namespace snug::cli {
namespace {

// 0x80 to 0x9f; 0 where there is nothing.
constexpr std::array<char16_t, 32> kUpperRow{0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                             0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017d, 0,
                                             0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                             0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

}  // namespace

std::optional<char> latin_letter(char32_t c) {
    if ((c >= 0x20 && c < 0x7f) || (c >= 0xa0 && c <= 0xff)) return static_cast<char>(c);
    const auto* const found = std::find(kUpperRow.begin(), kUpperRow.end(), c);
    if (c == 0 || found == kUpperRow.end()) return {};
    return static_cast<char>(0x80 + (found - kUpperRow.begin()));
}

bool is_latin(std::string_view utf8) {
    for (; !utf8.empty(); utf8.remove_prefix(first_character(utf8).bytes))
        if (!latin_letter(first_character(utf8).character)) return false;
    return true;
}

std::string latin_text(std::string_view utf8) {
    std::string latin;
    for (; !utf8.empty(); utf8.remove_prefix(first_character(utf8).bytes))
        latin += latin_letter(first_character(utf8).character).value_or('?');
    return latin;
}

}  // namespace snug::cli
