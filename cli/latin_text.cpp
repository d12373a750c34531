#include "cli/latin_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace snug::cli {
namespace {

// 0x80 to 0x9f; 0 where there is nothing.
constexpr std::array<char16_t, 32> kUpperRow{0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                             0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017d, 0,
                                             0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                             0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

/// The next character, and how many bytes it takes; a byte that is no UTF-8 stands for itself as U+FFFD.
struct Decoded {
    std::uint32_t character;
    std::size_t bytes;
};
Decoded decoded(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(0);
    if (first < 0x80) return {first, 1};
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    if (length == 0 || text.size() < length) return {0xfffd, 1};
    std::uint32_t character = first & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {0xfffd, 1};
        character = character << 6 | (byte(i) & 0x3fU);
    }
    return {character, length};
}

}  // namespace

std::string latin_text(std::string_view utf8) {
    std::string latin;
    while (!utf8.empty()) {
        const Decoded next = decoded(utf8);
        utf8.remove_prefix(next.bytes);
        const std::uint32_t c = next.character;
        const auto* found = std::find(kUpperRow.begin(), kUpperRow.end(), c);
        if ((c >= 0x20 && c < 0x7f) || (c >= 0xa0 && c <= 0xff))
            latin += static_cast<char>(c);
        else if (c != 0 && found != kUpperRow.end())
            latin += static_cast<char>(0x80 + (found - kUpperRow.begin()));
        else
            latin += '?';
    }
    return latin;
}

}  // namespace snug::cli
