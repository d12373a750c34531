#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "snug/formats/text_scan.h"

namespace snug {

/// The word at the start of an OFF file: [ST][C][N][4][n]OFF (Geomview's OFF(5)).
struct OffKeyword {
    std::string_view word;   ///< "CNOFF"
    std::string_view glued;  ///< what follows without a blank: "OFF16 24 0"; a number or nothing
    bool texture = false, colour = false, normal = false;
    bool other_space = false;  ///< vertices of four or of any number of coordinates
    /// Numbers of a vertex, where it has a colour of four.
    [[nodiscard]] std::size_t stride() const {
        return 3u + (normal ? 3u : 0u) + (colour ? 4u : 0u) + (texture ? 2u : 0u);
    }
};

/// None where the word is no such keyword, in whatever case.
[[nodiscard]] inline std::optional<OffKeyword> off_keyword(std::string_view word) {
    OffKeyword found;
    std::size_t at = 0;
    const auto take = [&](std::string_view lower) {
        if (!same_word(word.substr(at, lower.size()), lower)) return false;
        at += lower.size();
        return true;
    };
    found.texture = take("st");
    found.colour = take("c");
    found.normal = word.substr(at, 1) == "N" && take("n");
    found.other_space = take("4");
    found.other_space = take("n") || found.other_space;
    if (!take("off")) return {};
    found.word = word.substr(0, at);
    found.glued = word.substr(at);
    for (const char c : found.glued)
        if (!is_digit(c)) return {};
    return found;
}

}  // namespace snug
