#include "snug/base/utf8.h"

#include <algorithm>

namespace snug {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

bool is_high_half(char32_t unit) {
    return unit >= 0xD800 && unit < 0xDC00;
}
bool is_low_half(char32_t unit) {
    return unit >= 0xDC00 && unit < 0xE000;
}

}  // namespace

void append_utf8(char32_t character, std::string& text) {
    if (character > 0x10FFFF || is_high_half(character) || is_low_half(character)) character = kReplacement;
    const auto put = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    const auto put_rest = [&](int shift) { put(0x80 | (character >> shift & 0x3F)); };
    if (character < 0x80) return put(character);
    if (character < 0x800) {
        put(0xC0 | character >> 6);
    } else if (character < 0x10000) {
        put(0xE0 | character >> 12);
        put_rest(6);
    } else {
        put(0xF0 | character >> 18);
        put_rest(12);
        put_rest(6);
    }
    put_rest(0);
}

std::size_t character_bytes(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
    char32_t character = first & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
        character = character << 6 | (byte(i) & 0x3F);
    }
    constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool whole = character >= kLeast[length] && character <= 0x10FFFF && !is_high_half(character) &&
                       !is_low_half(character);
    return whole ? length : 0;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = character_bytes(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

std::optional<std::string> from_utf16(Bytes text) {
    if (text.size() < 2) return {};
    const auto byte = [&](std::size_t i) { return std::to_integer<unsigned>(text[i]); };
    const bool marked = (byte(0) == 0xFE && byte(1) == 0xFF) || (byte(0) == 0xFF && byte(1) == 0xFE);
    const bool big_end_first = marked ? byte(0) == 0xFE : byte(0) == 0;
    if (!marked && (byte(0) == 0) == (byte(1) == 0)) return {};

    const std::size_t count = text.size() / 2;
    const auto unit = [&](std::size_t i) -> char32_t {
        const unsigned a = byte(2 * i), b = byte(2 * i + 1);
        return big_end_first ? a << 8 | b : b << 8 | a;
    };
    std::string result;
    result.reserve(count);
    for (std::size_t i = marked ? 1 : 0; i < count; ++i) {
        char32_t character = unit(i);
        if (is_high_half(character) && i + 1 < count && is_low_half(unit(i + 1)))
            character = 0x10000 + ((character - 0xD800) << 10) + (unit(++i) - 0xDC00);
        append_utf8(character, result);
    }
    if (text.size() % 2 != 0) append_utf8(kReplacement, result);
    return result;
}

}  // namespace snug
