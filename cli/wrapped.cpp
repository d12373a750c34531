#include "cli/wrapped.h"

#include "snug/base/wide_text.h"

namespace snug::cli {
namespace {

constexpr std::size_t kWidth = 90;

}  // namespace

std::size_t columns_of(std::string_view text) {
    std::size_t columns = 0;
    while (!text.empty()) {
        const auto [character, bytes] = first_character(text);
        columns += is_wide(character) ? 2 : 1;
        text.remove_prefix(bytes);
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
        const std::string_view unit = unbroken(text);
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
