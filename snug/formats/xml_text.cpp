#include "snug/formats/xml_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

#include "snug/base/utf8.h"

namespace snug {
namespace {

bool append_reference(std::string_view digits, std::string& text) {
    const bool hex = !digits.empty() && (digits[0] == 'x' || digits[0] == 'X');
    if (hex) digits.remove_prefix(1);
    std::uint32_t character = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, character, hex ? 16 : 10);
    if (error != std::errc() || stop != end || digits.empty() || character == 0) return false;
    append_utf8(character, text);
    return true;
}

bool append_entity(std::string_view name, std::string& text) {
    static constexpr std::pair<std::string_view, char> kEntities[] = {
        {"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
    if (!name.empty() && name[0] == '#') return append_reference(name.substr(1), text);
    for (const auto& [known, letter] : kEntities) {
        if (name != known) continue;
        text.push_back(letter);
        return true;
    }
    return false;
}

}  // namespace

std::string_view without_xml_spaces(std::string_view text) {
    while (!text.empty() && is_xml_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_xml_space(text.back())) text.remove_suffix(1);
    return text;
}

bool expand_xml(std::string_view text, std::string& expanded) {
    expanded.clear();
    for (;;) {
        const std::size_t mark = std::min(text.find('&'), text.size());
        expanded.append(text.substr(0, mark));
        if (mark == text.size()) return true;
        text.remove_prefix(mark + 1);
        const std::size_t end = text.find(';');
        if (end == text.npos || !append_entity(text.substr(0, end), expanded)) return false;
        text.remove_prefix(end + 1);
    }
}

}  // namespace snug
