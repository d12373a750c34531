#include "snug/fabricate/kit/plain_name.h"

namespace snug {
namespace {

constexpr std::string_view kMarks = ".,:-+/=&'_";
// U+00C0 to U+017F without their accents; _ where no one letter stands for it.
constexpr std::string_view kLatin =
    "AAAAAA_CEEEEIIII_NOOOOO_OUUUUY__aaaaaa_ceeeeiiii_nooooo_ouuuuy_y"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIi__JjKk_LlLlLlL"
    "lLlNnNnNn___OoOoOo__RrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZz_";

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           kMarks.find(c) != std::string_view::npos;
}

/// What stands for the character whose UTF-8 begins with these bytes above 0x7f; 0 for nothing.
char letter_for(unsigned char lead, unsigned char next) {
    const bool continues = lead < 0xC0;                // the first byte has been seen to
    const bool accent = lead == 0xCC || lead == 0xCD;  // as macOS writes them: a letter of their own
    if (continues || accent) return 0;
    if (lead < 0xC3 || lead > 0xC5) return '_';
    return kLatin[static_cast<std::size_t>((lead - 0xC3) * 64 + (next & 0x3F))];
}

}  // namespace

std::string plain_name(std::string_view utf8) {
    std::string plain;
    for (std::size_t i = 0; i < utf8.size(); ++i) {
        const auto byte = [&](std::size_t at) {
            return at < utf8.size() ? static_cast<unsigned char>(utf8[at]) : static_cast<unsigned char>(0);
        };
        char c = utf8[i];
        if (byte(i) >= 0x80) {
            c = letter_for(byte(i), byte(i + 1));
            if (c == 0 || (c == '_' && !plain.empty() && plain.back() == '_')) continue;
        } else if (!is_plain(c)) {
            // Spaces, control characters and marks alike part words.
            if (plain.empty() || plain.back() == ' ') continue;
            c = ' ';
        }
        plain += c;
    }
    while (!plain.empty() && plain.back() == ' ') plain.pop_back();
    return plain;
}

}  // namespace snug
