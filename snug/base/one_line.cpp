#include "snug/base/one_line.h"

#include "snug/base/utf8.h"

namespace snug {
namespace {

bool is_between(std::string_view character, std::string_view first, std::string_view last) {
    return character.size() == first.size() && character >= first && character <= last;
}

bool ends_a_line(std::string_view character) {
    if (character.size() == 1) return static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7F;
    return is_between(character, "\xC2\x80", "\xC2\x9F") ||
           is_between(character, "\xE2\x80\xA8", "\xE2\x80\xA9");
}

bool turns_direction(std::string_view character) {
    return is_between(character, "\xE2\x80\x8E", "\xE2\x80\x8F") ||
           is_between(character, "\xE2\x80\xAA", "\xE2\x80\xAE") ||
           is_between(character, "\xE2\x81\xA6", "\xE2\x81\xA9");
}

}  // namespace

std::string one_line(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const std::size_t bytes = character_bytes(text);
        const std::string_view character = text.substr(0, bytes == 0 ? 1 : bytes);
        text.remove_prefix(character.size());
        if (ends_a_line(character))
            line += ' ';
        else if (bytes == 0)
            append_utf8(U'\uFFFD', line);
        else if (!turns_direction(character))
            line += character;
    }
    return line;
}

}  // namespace snug
