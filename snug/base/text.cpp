#include "snug/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fast_float/fast_float.h>

#include "snug/base/one_line.h"

namespace snug {
namespace {

constexpr double kPowersOfTen[] = {1,    1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// value * 10^power within a few units of the last place.
double shifted(double value, int power) {
    for (; power > 22; power -= 22) value *= 1e22;
    for (; power < -22; power += 22) value /= 1e22;
    return power < 0 ? value / kPowersOfTen[-power] : value * kPowersOfTen[power];
}

/// A decimal number, digits * 10^exponent.
struct Decimal {
    std::uint64_t digits = 0;
    int exponent = 0;
};

bool reads_back(Decimal decimal, float value) {
    const std::string text = std::to_string(decimal.digits) + "e" + std::to_string(decimal.exponent);
    float read = 0;
    const auto result = fast_float::from_chars(text.data(), text.data() + text.size(), read);
    return result.ec == std::errc() && read == value;
}

/// Whether one of the two numbers of `count` digits next to the value reads back as it; the nearer one first.
/// All floats have one of nine digits, and where `count` digits will do, more will do as well.
bool find_decimal(float value, int leading_exponent, int count, Decimal& found) {
    const int exponent = leading_exponent + 1 - count;
    const double scaled = shifted(value, -exponent);
    const auto below = static_cast<std::uint64_t>(scaled);
    const double rest = scaled - static_cast<double>(below);
    const bool up = rest > 0.5 || (rest == 0.5 && below % 2 == 1);
    for (const std::uint64_t digits : {below + (up ? 1 : 0), below + (up ? 0 : 1)}) {
        if (!reads_back({digits, exponent}, value)) continue;
        found = {digits, exponent};
        return true;
    }
    return false;
}

/// For finite values above 0.
Decimal shortest_decimal(float value) {
    int leading_exponent = 0;
    while (leading_exponent < 38 && shifted(value, -leading_exponent) >= 10) ++leading_exponent;
    while (shifted(value, -leading_exponent) < 1) --leading_exponent;
    Decimal found;
    int too_few = 0, enough = 9;
    while (enough - too_few > 1) {
        const int count = (too_few + enough) / 2;
        (find_decimal(value, leading_exponent, count, found) ? enough : too_few) = count;
    }
    if (enough == 9) find_decimal(value, leading_exponent, enough, found);
    while (found.digits % 10 == 0) {
        found.digits /= 10;
        ++found.exponent;
    }
    return found;
}

}  // namespace

std::string number(double value, int decimals) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    static constexpr double kPowers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    while (decimals > 0 && std::fabs(value) * kPowers[decimals] > 9e17) --decimals;
    const double scaled = std::min(std::floor(std::fabs(value) * kPowers[decimals] + 0.5), 9.2e18);
    std::string digits = std::to_string(static_cast<std::uint64_t>(scaled));
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) {
        digits.insert(digits.size() - places, ".");
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.') digits.pop_back();
    }
    return value < 0 && digits != "0" ? "-" + digits : digits;
}

std::string shortest(float value) {
    if (std::isnan(value)) return "nan";
    const std::string sign = std::signbit(value) ? "-" : "";
    if (std::isinf(value)) return sign + "inf";
    if (value == 0) return sign + "0";
    const Decimal decimal = shortest_decimal(std::fabs(value));
    std::string digits = std::to_string(decimal.digits);
    const int count = static_cast<int>(digits.size());
    const int before_point = count + decimal.exponent;
    if (before_point < -3 || before_point > 9) {
        if (count > 1) digits.insert(1, ".");
        return sign + digits + "e" + std::to_string(before_point - 1);
    }
    if (before_point <= 0)
        return sign + "0." + std::string(static_cast<std::size_t>(-before_point), '0') + digits;
    if (before_point < count) return sign + digits.insert(static_cast<std::size_t>(before_point), ".");
    return sign + digits + std::string(static_cast<std::size_t>(before_point - count), '0');
}

std::string dimensions(Vec3d size, int decimals) {
    return number(size.x, decimals) + " x " + number(size.y, decimals) + " x " + number(size.z, decimals);
}

std::string grouped(unsigned long long value) {
    std::string digits = std::to_string(value);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
    return digits;
}

std::string counted(unsigned long long count, std::string_view one, std::string_view many) {
    return grouped(count) + " " + std::string(count == 1 ? one : many);
}

std::string Quoted::operator()(std::string_view text, std::size_t longest) const {
    std::size_t end = std::min(text.size(), longest);
    // Never half a character: the bytes behind its first have the upper bits 10.
    for (int back = 0; back < 3 && end > 0 && end < text.size() && (text[end] & 0xC0) == 0x80; ++back) --end;
    return "\"" + one_line(text.substr(0, end)) + (end < text.size() ? "...\"" : "\"");
}

std::vector<std::string_view> words_between(std::string_view text, char separator) {
    std::vector<std::string_view> words;
    for (bool more = !text.empty(); more;) {
        const std::size_t end = text.find(separator);
        more = end != std::string_view::npos;
        words.push_back(text.substr(0, end));
        text.remove_prefix(more ? end + 1 : text.size());
    }
    return words;
}

}  // namespace snug
