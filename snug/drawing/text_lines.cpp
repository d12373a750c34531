#include "snug/drawing/text_lines.h"

#include <array>

#include "snug/base/wide_text.h"

namespace snug {
namespace {

// Thousandths of the height, from space to ~.
constexpr std::array<short, 95> kWidths{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr int kOther = 560, kFullWidth = 1000;
constexpr double kBoldWider = 1.07;

/// Beyond Latin letters and the marks of sentences a letter may be as wide as it is high: fonts for Japanese
/// have those of Greek and Cyrillic so.
int thousandths_of(char32_t c) {
    if (c >= ' ' && c <= '~') return kWidths[c - ' '];
    const bool latin = c < 0x250 || (c >= 0x2010 && c < 0x2100) || c == 0x2122 || c == 0xfffd;
    return latin && !is_wide(c) ? kOther : kFullWidth;
}

/// The bytes of `text` that fit into the width, at least one character.
std::size_t fitting(std::string_view text, double width_mm, double height_mm, bool bold) {
    std::size_t fits = 0;
    while (fits < text.size()) {
        const std::size_t end = fits + first_character(text.substr(fits)).bytes;
        if (fits > 0 && text_width(text.substr(0, end), height_mm, bold) > width_mm) break;
        fits = end;
    }
    return fits;
}

}  // namespace

double text_width(std::string_view text, double height_mm, bool bold) {
    int thousandths = 0;
    while (!text.empty()) {
        const auto [character, bytes] = first_character(text);
        thousandths += thousandths_of(character);
        text.remove_prefix(bytes);
    }
    return thousandths * 0.001 * height_mm * (bold ? kBoldWider : 1);
}

std::vector<std::string> lines_of(std::string_view text, double width_mm, double height_mm, bool bold) {
    std::vector<std::string> lines;
    std::string line;
    bool blank = false;
    while (!text.empty()) {
        std::string_view word = unbroken(text);
        text.remove_prefix(word.size());
        const std::string longer = line + (blank && !line.empty() ? " " : "") + std::string(word);
        blank = !text.empty() && text[0] == ' ';
        if (blank) text.remove_prefix(1);
        if (text_width(longer, height_mm, bold) <= width_mm) {
            line = longer;
            continue;
        }
        if (!line.empty()) lines.push_back(line);
        while (text_width(word, height_mm, bold) > width_mm) {
            const std::size_t part = fitting(word, width_mm, height_mm, bold);
            if (part >= word.size()) break;
            lines.emplace_back(word.substr(0, part));
            word.remove_prefix(part);
        }
        line = std::string(word);
    }
    if (!line.empty() || lines.empty()) lines.push_back(line);
    return lines;
}

}  // namespace snug
