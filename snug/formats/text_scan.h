#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "snug/base/message.h"

namespace snug {

enum class CharKind : std::uint8_t { in_word, blank, line_end };

inline constexpr std::array<CharKind, 256> kCharKinds = [] {
    std::array<CharKind, 256> kinds{};
    // 0x1a is the end of a text for old systems, which some programs still write.
    for (const char c : {' ', '\t', '\v', '\f', '\0', '\x1a'})
        kinds[static_cast<unsigned char>(c)] = CharKind::blank;
    for (const char c : {'\n', '\r'}) kinds[static_cast<unsigned char>(c)] = CharKind::line_end;
    return kinds;
}();

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Most numbers are a sign and a few digits around a point. Their digits and the power of ten are exact in
/// double, so that a single division rounds them just as the full conversion does. Gives the place behind the
/// number, or `begin` for all others.
inline const char* to_plain_number(const char* begin, const char* end, double& value) {
    constexpr std::int64_t kGreatestExact = std::int64_t{1} << 53;  // double holds every whole number to here
    constexpr std::ptrdiff_t kMostDigits = 16;
    constexpr double kPowersOfTen[kMostDigits + 1] = {1,   1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7, 1e8,
                                                      1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};
    const bool negative = begin < end && *begin == '-';
    const char* const first = begin + negative;
    const char* const last = end - first > kMostDigits + 1 ? first + kMostDigits + 1 : end;  // and a point
    std::int64_t digits = 0;
    const char* at = first;
    for (; at < last && is_digit(*at); ++at) digits = digits * 10 + (*at - '0');
    if (at == first) return begin;
    std::ptrdiff_t decimals = 0;
    if (at < last && *at == '.') {
        const char* const point = at++;
        for (; at < last && is_digit(*at); ++at) digits = digits * 10 + (*at - '0');
        decimals = at - point - 1;
    }
    if (digits > kGreatestExact) return begin;
    value = static_cast<double>(digits);
    if (decimals > 0) value /= kPowersOfTen[decimals];
    if (negative) value = -value;
    return at;
}

/// "line 5: ", counted from 1.
[[nodiscard]] inline Message at_line(std::size_t line) {
    return say("at_line", {{"line", std::to_string(line)}});
}

/// A cursor over the bytes of a text file, line by line and word by word. Nothing is copied and no locale is
/// asked. Lines end with LF, CR LF or CR. A byte order mark at the start is no part of the first word.
class TextScan {
  public:
    explicit TextScan(std::span<const std::byte> bytes);

    [[nodiscard]] bool at_end() const { return at_ == end_; }
    [[nodiscard]] std::size_t line() const { return line_; }
    /// "line 12: "
    [[nodiscard]] Message place() const { return at_line(line_); }

    /// The next word of this line; empty at its end. A comment (from `comment` on) ends the line.
    std::string_view word(char comment = '#') {
        while (at_ < end_ && kind(*at_) == CharKind::blank) ++at_;
        if (at_ < end_ && *at_ == comment)
            while (at_ < end_ && kind(*at_) != CharKind::line_end) ++at_;
        const char* begin = at_;
        while (at_ < end_ && kind(*at_) == CharKind::in_word) ++at_;
        return {begin, static_cast<std::size_t>(at_ - begin)};
    }
    /// Takes the next word of this line if it is a plain number (to_plain_number). False for all others, and
    /// nothing is taken: ask word(). Much faster than that for the millions of numbers in a file.
    bool plain_number(double& value) {
        const char* const begin = behind_blanks();
        const char* const after = to_plain_number(begin, end_, value);
        if (after == begin || !ends_word(after)) return false;
        at_ = after;
        return true;
    }
    /// The same for whole numbers from 1, up to nine digits. The word may go on behind a `mark`, and what
    /// stands there is passed over unless it ends with a backslash.
    bool plain_whole(std::uint32_t& value, char mark) {
        constexpr std::ptrdiff_t kMostDigits = 9;
        const char* const begin = behind_blanks();
        const char* after = begin;
        std::uint32_t found = 0;
        for (; after < end_ && is_digit(*after) && after - begin < kMostDigits; ++after)
            found = found * 10 + static_cast<std::uint32_t>(*after - '0');
        if (found == 0) return false;
        if (after < end_ && *after == mark)
            while (!ends_word(after)) ++after;
        if (!ends_word(after) || after[-1] == '\\') return false;
        at_ = after;
        value = found;
        return true;
    }
    /// Goes to the start of the next line.
    void next_line() {
        while (at_ < end_ && kind(*at_) != CharKind::line_end) ++at_;
        if (at_ == end_) return;
        const char first = *at_++;
        if (first == '\r' && at_ < end_ && *at_ == '\n') ++at_;
        ++line_;
    }
    /// The next word of the file, lines passed over; empty at the end.
    std::string_view word_anywhere(char comment = '#');

  private:
    static CharKind kind(char c) { return kCharKinds[static_cast<unsigned char>(c)]; }

    [[nodiscard]] bool ends_word(const char* at) const {
        return at == end_ || kind(*at) != CharKind::in_word;
    }
    [[nodiscard]] const char* behind_blanks() const {
        const char* at = at_;
        while (at < end_ && kind(*at) == CharKind::blank) ++at;
        return at;
    }

    const char* at_;
    const char* end_;
    std::size_t line_ = 1;
};

/// The whole word as a finite number; a leading + is allowed.
[[nodiscard]] bool to_number(std::string_view word, double& value);
[[nodiscard]] bool to_number(std::string_view word, std::int64_t& value);

/// As to_number(), and true as well for what programs write where a coordinate is no number (nan, -inf,
/// -nan(ind), 1.#QNAN, 1e999, na): `value` is NaN then.
[[nodiscard]] bool to_coordinate(std::string_view word, double& value);

/// Case of ASCII letters ignored; `lower` must be in lower case.
[[nodiscard]] bool same_word(std::string_view word, std::string_view lower);

}  // namespace snug
