#include "snug/drawing/stroke_text.h"

#include <cstddef>

namespace snug {
namespace {

constexpr double kCapital = 0.7;        // of the height
constexpr double kSmallCapital = 0.75;  // of a capital
constexpr double kWide = 4, kHigh = 6;  // a letter's raster
constexpr double kBetween = 1.6;        // steps of the raster between letters
constexpr double kSpace = 3.4;

struct Letter {
    char character;
    std::string_view strokes;  ///< points as two digits, x then y upward; a space lifts the pen
};

constexpr Letter kLetters[] = {
    {'A', "0004264440 0242"},
    {'B', "00063645443303 3342413000"},
    {'C', "4536160501103041"},
    {'D', "00062644422000"},
    {'E', "46060040 0333"},
    {'F', "460600 0333"},
    {'G', "45361605011030414323"},
    {'H', "0006 4046 0343"},
    {'I', "1030 2026 1636"},
    {'J', "4641301001"},
    {'K', "0006 460340"},
    {'L', "060040"},
    {'M', "0006234640"},
    {'N', "00064046"},
    {'O', "100105163645413010"},
    {'P', "00063645443303"},
    {'Q', "100105163645413010 2240"},
    {'R', "00063645443303 2340"},
    {'S', "453616050413334241301001"},
    {'T', "0646 2620"},
    {'U', "060110304146"},
    {'V', "062046"},
    {'W', "0610233046"},
    {'X', "0046 0640"},
    {'Y', "062346 2320"},
    {'Z', "06460040"},
    {'0', "100105163645413010 1135"},
    {'1', "042620 0040"},
    {'2', "05163645440040"},
    {'3', "05163645443313 334241301001"},
    {'4', "30360242"},
    {'5', "460603334241301001"},
    {'6', "4536160501103041423303"},
    {'7', "064610"},
    {'8', "13040516364544331302011030414233"},
    {'9', "0110304145361605041343"},
    {'-', "0343"},
    {'+', "0343 2125"},
    {'.', "1011212010"},
    {'/', "0046"},
};

std::string_view strokes_of(char character) {
    for (const Letter& letter : kLetters)
        if (letter.character == character) return letter.strokes;
    return {};
}

/// A letter's lines with its lower left corner at (x, 0), y downward, in steps of the raster.
void add_letter(std::vector<std::vector<Vec2d>>& lines, std::string_view strokes, double x, double scale) {
    lines.emplace_back();
    for (std::size_t i = 0; i < strokes.size(); i += 2) {
        if (strokes[i] == ' ') {
            lines.emplace_back();
            ++i;
        }
        lines.back().push_back({x + (strokes[i] - '0') * scale, -(strokes[i + 1] - '0') * scale});
    }
}

Vec2d turned(Vec2d p, double turn_deg) {
    if (turn_deg == 90) return {-p.y, p.x};
    if (turn_deg == 180) return {-p.x, -p.y};
    if (turn_deg == 270) return {p.y, -p.x};
    return p;
}

}  // namespace

std::vector<std::vector<Vec2d>> stroke_text(std::string_view text, Vec2d at, double height_mm,
                                            TextAnchor anchor, double turn_deg) {
    std::vector<std::vector<Vec2d>> lines;
    double x = 0, width = 0;
    for (const char character : text) {
        const bool small = character >= 'a' && character <= 'z';
        const double scale = small ? kSmallCapital : 1;
        const std::string_view strokes =
            strokes_of(small ? static_cast<char>(character - 'a' + 'A') : character);
        if (character == ' ') x += kSpace;
        if (strokes.empty()) continue;
        add_letter(lines, strokes, x, scale);
        width = x + kWide * scale;
        x = width + kBetween;
    }
    const double step = kCapital * height_mm / kHigh;
    const double shift = anchor == TextAnchor::start ? 0 : anchor == TextAnchor::middle ? width / 2 : width;
    for (auto& line : lines)
        for (Vec2d& p : line) p = at + turned({(p.x - shift) * step, p.y * step}, turn_deg);
    return lines;
}

}  // namespace snug
