#include "snug/drawing/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "snug/base/text.h"
#include "snug/base/utf8.h"
#include "snug/base/wide_text.h"

namespace snug {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::string_view kEllipsis = "\xE2\x80\xA6";

/// Bytes of the character at the front of `text`, 0 if there is none that XML allows.
std::size_t xml_character_bytes(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < 0x20 && lead != '\t' && lead != '\n' && lead != '\r') return 0;
    const std::string_view character = text.substr(0, character_bytes(text));
    return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF" ? 0 : character.size();
}

std::size_t step(std::string_view text) {
    return std::max<std::size_t>(1, xml_character_bytes(text));
}

/// Bytes of as many characters as take the room of `count` letters, or of all: at least one, if any room.
std::size_t bytes_of_characters(std::string_view text, std::size_t count) {
    std::size_t bytes = 0, taken = 0;
    while (taken < count && bytes < text.size()) {
        taken += is_wide(first_character(text.substr(bytes)).character) ? 2 : 1;
        if (taken > count && bytes > 0) break;
        bytes += step(text.substr(bytes));
    }
    return bytes;
}

/// The last place up to `end` where a line of the text may break: at a blank, or beside a wide character; 0
/// if there is none.
std::size_t last_break(std::string_view text, std::size_t end) {
    std::size_t found = 0;
    for (std::size_t at = 0; at <= end && at < text.size();) {
        const bool blank = text[at] == ' ';
        if (blank || (at > 0 && text[at - 1] != ' ')) found = at;
        at += blank ? 1 : unbroken(text.substr(at)).size();
    }
    return found;
}

/// As wrapped(), each line as full as it can be.
std::vector<std::string> broken(std::string_view text, std::size_t longest, std::size_t most_lines) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        std::size_t end = bytes_of_characters(text, longest);
        if (end < text.size()) {
            if (lines.size() + 1 == most_lines) {
                end = bytes_of_characters(text, longest - 1);
                lines.push_back(std::string(text.substr(0, end)) + std::string(kEllipsis));
                return lines;
            }
            if (const std::size_t place = last_break(text, end); place > 0) end = place;
        }
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
        while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    }
    return lines;
}

}  // namespace

std::string hex(Color color) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (const int part : {color.red, color.green, color.blue}) {
        text += kDigits[part / 16];
        text += kDigits[part % 16];
    }
    return text;
}

Color mixed(Color a, Color b, double share) {
    const auto mix = [share](int from, int to) {
        return static_cast<std::uint8_t>(std::floor(from + (to - from) * share + 0.5));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

std::string more_fonts(Language language) {
    const std::string_view fonts = language == Language::japanese
                                       ? ", 'Hiragino Sans', 'Yu Gothic', Meiryo, 'Noto Sans CJK JP', "
                                         "'Noto Sans JP', IPAPGothic, IPAGothic"
                                       : "";
    return std::string(fonts) + ", sans-serif";
}

std::string xml_text(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t bytes = xml_character_bytes(text);
        switch (text.front()) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&apos;";
                break;
            default:
                safe += bytes == 0 ? kReplacement : text.substr(0, bytes);
        }
        text.remove_prefix(step(text));
    }
    return safe;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t longest, std::size_t most_lines) {
    std::vector<std::string> lines = broken(text, longest, most_lines);
    if (lines.size() == most_lines) return lines;
    while (longest > 1) {
        std::vector<std::string> narrower = broken(text, --longest, most_lines);
        if (narrower.size() > lines.size()) break;
        lines = std::move(narrower);
    }
    return lines;
}

}  // namespace snug
