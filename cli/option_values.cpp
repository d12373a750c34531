#include "cli/option_values.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include "snug/base/text.h"

namespace snug::cli {
namespace {

template <class T>
bool parse_number(std::string_view text, T& value) {
    const char* end = text.data() + text.size();
    if constexpr (std::is_integral_v<T>) {
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        return error == std::errc() && stop == end;
    } else {
        const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
        return error == std::errc() && stop == end;
    }
}

template <class T>
Result<Vec3<T>> parse_three(const std::string& option, std::string_view text, char separator,
                            const char* example) {
    Vec3<T> values;
    std::string_view rest = text;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t end = axis < 2 ? rest.find(separator) : rest.size();
        if (end == std::string_view::npos || !parse_number(rest.substr(0, end), values[axis]))
            return fail(ErrorKind::usage, fmt::format("{} takes three numbers such as {}, not {}", option,
                                                      example, quoted(text)));
        rest.remove_prefix(axis < 2 ? end + 1 : end);
    }
    return values;
}

/// Numbers between separators; none where one is no number.
std::vector<double> parse_list(std::string_view text, char separator) {
    std::vector<double> values;
    for (bool more = true; more;) {
        const std::size_t end = text.find(separator);
        more = end != std::string_view::npos;
        if (!parse_number(text.substr(0, end), values.emplace_back())) return {};
        text.remove_prefix(more ? end + 1 : text.size());
    }
    return values;
}

}  // namespace

Result<Vec3i> parse_counts(const std::string& option, std::string_view text) {
    return parse_three<int>(option, text, 'x', "30x18x18");
}

Result<Vec3d> parse_sizes(const std::string& option, std::string_view text) {
    return parse_three<double>(option, text, 'x', "15x15x22");
}

Result<Vec2d> parse_rectangle(const std::string& option, std::string_view text) {
    Vec2d sides;
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos || !parse_number(text.substr(0, cross), sides.x) ||
        !parse_number(text.substr(cross + 1), sides.y))
        return fail(ErrorKind::usage,
                    fmt::format("{} takes two lengths such as 1000x600, not {}", option, quoted(text)));
    return sides;
}

Result<Vec3d> parse_vector(const std::string& option, std::string_view text) {
    return parse_three<double>(option, text, ',', "0,90,0");
}

Result<Walls> parse_walls(const std::string& option, std::string_view text) {
    const std::vector<double> values = parse_list(text, ',');
    if (values.size() == 1) return equal_walls(values[0]);
    if (values.size() == 3) return paired_walls({values[0], values[1], values[2]});
    if (values.size() == 6) return Walls{values[0], values[1], values[2], values[3], values[4], values[5]};
    return fail(
        ErrorKind::usage,
        fmt::format("{} takes one number of mm, three (x,y,z) or six (floor,roof,back,front,left,right) "
                    "such as 50 or 40,50,50, not {}",
                    option, quoted(text)));
}

Result<Clearance> parse_clearance(const std::string& option, std::string_view text) {
    const std::vector<double> values = parse_list(text, ',');
    if (values.size() == 1) return Clearance(values[0]);
    if (values.size() == 3) {
        const Vec3d both{values[0], values[1], values[2]};
        return Clearance{both, both};
    }
    if (values.size() == 6)
        return Clearance{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
    return fail(ErrorKind::usage,
                fmt::format("{} takes one number of mm, three (x,y,z) or six (x,y,z of the lower foam, then "
                            "of the upper) such as 1 or 0,2,2, not {}",
                            option, quoted(text)));
}

Result<Vec3d> parse_notches(const std::string& option, std::string_view text) {
    const std::vector<double> values = parse_list(text, 'x');
    if (values.size() == 2 || (values.size() == 3 && values[2] > 0))
        return Vec3d{values[0], values[1], values.size() == 3 ? values[2] : 0};
    return fail(
        ErrorKind::usage,
        fmt::format("{} takes width x depth in mm, and the room outwards if you like, such as 80x40 or "
                    "80x40x25, not {}",
                    option, quoted(text)));
}

Result<Vec2d> parse_pair(const std::string& option, std::string_view text) {
    const std::vector<double> values = parse_list(text, ',');
    if (values.size() == 1) return Vec2d{values[0], values[0]};
    if (values.size() == 2) return Vec2d{values[0], values[1]};
    return fail(ErrorKind::usage, fmt::format("{} takes one or two numbers of mm such as 0 or -20,10, not {}",
                                              option, quoted(text)));
}

Result<double> parse_length(const std::string& option, std::string_view text) {
    double value = 0;
    if (!parse_number(text, value))
        return fail(ErrorKind::usage, fmt::format("{} takes a number of mm, not {}", option, quoted(text)));
    return value;
}

Result<int> parse_integer(const std::string& option, std::string_view text) {
    int value = 0;
    if (!parse_number(text, value))
        return fail(ErrorKind::usage, fmt::format("{} takes a whole number, not {}", option, quoted(text)));
    return value;
}

Result<Price> parse_price(const std::string& option, std::string_view text) {
    const std::size_t end = std::min(text.find_first_not_of("+-.0123456789"), text.size());
    Price price;
    std::string_view currency = text.substr(end);
    while (!currency.empty() && currency.front() == ' ') currency.remove_prefix(1);
    price.currency = std::string(currency);
    const bool word = currency.find_first_of("0123456789.,;") == std::string_view::npos;
    if (!word || !parse_number(text.substr(0, end), price.amount))
        return fail(ErrorKind::usage,
                    fmt::format("{} takes the price of a litre as a number, with the currency behind it if "
                                "you like, such as 12.50 or 12.50EUR, not {}",
                                option, quoted(text)));
    return price;
}

Result<std::vector<int>> parse_numbers(const std::string& option, std::string_view text) {
    constexpr int kMost = 100'000;
    const auto refuse = [&] {
        return fail(ErrorKind::usage,
                    fmt::format("{} takes numbers and ranges from 1 upward such as 2,5-9, not {}", option,
                                quoted(text)));
    };
    std::vector<int> numbers;
    std::string_view rest = text;
    for (bool more = true; more;) {
        const std::size_t end = rest.find(',');
        more = end != std::string_view::npos;
        const std::string_view word = rest.substr(0, end);
        const std::size_t dash = word.find('-');
        int first = 0, last = 0;
        if (!parse_number(word.substr(0, dash), first)) return refuse();
        if (dash == std::string_view::npos)
            last = first;
        else if (!parse_number(word.substr(dash + 1), last))
            return refuse();
        if (first < 1 || last < first || last - first >= kMost - static_cast<int>(numbers.size()))
            return refuse();
        for (int number = first; number <= last; ++number) numbers.push_back(number);
        rest.remove_prefix(more ? end + 1 : rest.size());
    }
    return numbers;
}

Result<std::array<double, 4>> parse_plane(const std::string& option, std::string_view text) {
    const std::vector<double> values = parse_list(text, ',');
    if (values.size() != 4)
        return fail(ErrorKind::usage,
                    fmt::format("{} takes a direction and a distance such as 0,0,1,12, not {}", option,
                                quoted(text)));
    return std::array<double, 4>{values[0], values[1], values[2], values[3]};
}

}  // namespace snug::cli
