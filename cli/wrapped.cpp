#include "cli/wrapped.h"

#include <algorithm>

#include "snug/base/utf8.h"

namespace snug::cli {
namespace {

constexpr std::size_t kWidth = 90;

char32_t character_of(std::string_view bytes) {
    static constexpr unsigned kLead[] = {0x7f, 0x7f, 0x1f, 0x0f, 0x07};
    char32_t character = static_cast<unsigned char>(bytes[0]) & kLead[std::min<std::size_t>(bytes.size(), 4)];
    for (const char next : bytes.substr(1))
        character = character << 6 | (static_cast<unsigned char>(next) & 0x3f);
    return character;
}

/// East Asian wide and fullwidth characters, by their blocks.
bool is_wide(char32_t c) {
    return (c >= 0x1100 && c <= 0x115f) || (c >= 0x2e80 && c <= 0xa4cf) || (c >= 0xac00 && c <= 0xd7a3) ||
           (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe30 && c <= 0xfe6f) || (c >= 0xff01 && c <= 0xff60) ||
           (c >= 0xffe0 && c <= 0xffe6) || (c >= 0x1f300 && c <= 0x1faff) || (c >= 0x20000 && c <= 0x3fffd);
}

/// The bytes of the text's first character, or of what stands in its place.
std::size_t step(std::string_view text) {
    return std::max<std::size_t>(character_bytes(text), 1);
}

bool one_of(char32_t character, std::u32string_view set) {
    return set.find(character) != set.npos;
}

/// What must stay together at the text's front: up to a blank, or to a place between two characters of which
/// one is wide.
std::string_view unit_of(std::string_view text) {
    std::size_t at = 0;
    char32_t before = 0;
    while (at < text.size() && text[at] != ' ') {
        const std::size_t bytes = step(text.substr(at));
        const char32_t character = character_of(text.substr(at, bytes));
        const bool may_break = at > 0 && (is_wide(before) || is_wide(character));
        if (may_break && !one_of(character, U"、。，．：；）」』】々ーっゃゅょッャュョ") &&
            !one_of(before, U"（「『【"))
            break;
        before = character;
        at += bytes;
    }
    return text.substr(0, at);
}

}  // namespace

std::size_t columns_of(std::string_view text) {
    std::size_t columns = 0;
    for (std::size_t bytes = 0; !text.empty(); text.remove_prefix(bytes)) {
        bytes = step(text);
        columns += is_wide(character_of(text.substr(0, bytes))) ? 2 : 1;
    }
    return columns;
}

std::string padded(std::string_view text, std::size_t columns) {
    const std::size_t own = columns_of(text);
    return std::string(text) + std::string(own < columns ? columns - own : 0, ' ');
}

std::string wrapped(std::string_view text, std::size_t indent) {
    std::string lines;
    std::size_t length = 0;
    bool blank = false;
    while (!text.empty()) {
        const std::string_view unit = unit_of(text);
        text.remove_prefix(unit.size());
        const std::size_t columns = columns_of(unit);
        if (length > 0 && length + (blank ? 1 : 0) + columns > kWidth) {
            lines += "\n" + std::string(indent, ' ');
            length = 0;
        } else if (blank && length > 0) {
            lines += ' ';
            ++length;
        }
        lines += unit;
        length += columns;
        blank = !text.empty() && text[0] == ' ';
        if (blank) text.remove_prefix(1);
    }
    return lines;
}

}  // namespace snug::cli
