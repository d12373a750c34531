#include "snug/base/wide_text.h"

#include <algorithm>

#include "snug/base/utf8.h"

namespace snug {
namespace {

constexpr std::u32string_view kNotFirst =
    U"、。，．・：；？！）〕］｝〉》」』】゛゜ヽヾゝゞ々ー～％ぁぃぅぇぉっゃゅょゎァィゥェォッャュョヮヵヶ"
    U",.:;?!)]}%";
constexpr std::u32string_view kNotLast = U"（〔［｛〈《「『【([{";

bool one_of(char32_t character, std::u32string_view set) {
    return set.find(character) != std::u32string_view::npos;
}

}  // namespace

FirstCharacter first_character(std::string_view text) {
    static constexpr unsigned kLead[] = {0x7f, 0x7f, 0x1f, 0x0f, 0x07};
    const std::size_t bytes = character_bytes(text);
    if (bytes == 0) return {0xfffd, 1};
    char32_t character = static_cast<unsigned char>(text[0]) & kLead[bytes];
    for (const char next : text.substr(1, bytes - 1))
        character = character << 6 | (static_cast<unsigned char>(next) & 0x3f);
    return {character, bytes};
}

bool is_wide(char32_t c) {
    return (c >= 0x1100 && c <= 0x115f) || (c >= 0x2e80 && c <= 0xa4cf) || (c >= 0xac00 && c <= 0xd7a3) ||
           (c >= 0xf900 && c <= 0xfaff) || (c >= 0xfe30 && c <= 0xfe6f) || (c >= 0xff01 && c <= 0xff60) ||
           (c >= 0xffe0 && c <= 0xffe6) || (c >= 0x1f300 && c <= 0x1faff) || (c >= 0x20000 && c <= 0x3fffd);
}

std::string_view unbroken(std::string_view text) {
    std::size_t at = 0;
    char32_t before = 0;
    while (at < text.size() && text[at] != ' ') {
        const auto [character, bytes] = first_character(text.substr(at));
        const bool may_break = at > 0 && (is_wide(before) || is_wide(character));
        if (may_break && !one_of(character, kNotFirst) && !one_of(before, kNotLast)) break;
        before = character;
        at += bytes;
    }
    return text.substr(0, at);
}

}  // namespace snug
