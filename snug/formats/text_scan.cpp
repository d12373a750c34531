#include "snug/formats/text_scan.h"

#include <charconv>
#include <cmath>
#include <limits>

#include <fast_float/fast_float.h>

namespace snug {
namespace {

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
    return word;
}

/// Old C libraries write 1.#IND, 1.#QNAN0 and 1.#INF.
bool says_no_number(std::string_view word) {
    word = without_plus(word);
    if (word.empty()) return false;
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = fast_float::from_chars(word.data(), end, value);
    if (stop == end) return error == std::errc::result_out_of_range || !std::isfinite(value);
    if (word[0] == '-') word.remove_prefix(1);
    return word.substr(0, 3) == "1.#" || same_word(word, "na") || same_word(word, "n/a") ||
           same_word(word, "qnan") || same_word(word, "snan");
}

}  // namespace

TextScan::TextScan(std::span<const std::byte> bytes)
    : at_(reinterpret_cast<const char*>(bytes.data())), end_(at_ + bytes.size()) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (std::string_view(at_, bytes.size()).substr(0, 3) == kByteOrderMark) at_ += 3;
}

std::string_view TextScan::word_anywhere(char comment) {
    for (;;) {
        const std::string_view found = word(comment);
        if (!found.empty() || at_end()) return found;
        next_line();
    }
}

bool to_number(std::string_view word, double& value) {
    word = without_plus(word);
    const char* end = word.data() + word.size();
    if (!word.empty() && to_plain_number(word.data(), end, value) == end) return true;
    const auto [stop, error] = fast_float::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end && !word.empty() && std::isfinite(value);
}

bool to_coordinate(std::string_view word, double& value) {
    if (to_number(word, value)) return true;
    if (!says_no_number(word)) return false;
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
}

bool to_number(std::string_view word, std::int64_t& value) {
    word = without_plus(word);
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end && !word.empty();
}

bool same_word(std::string_view word, std::string_view lower) {
    if (word.size() != lower.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i];
        if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != lower[i]) return false;
    }
    return true;
}

}  // namespace snug
