#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "snug/base/vec.h"

namespace snug {

/// A number with at most `decimals` (0 to 9) digits behind the point, trailing zeros dropped; never a
/// locale's comma, never an exponent, never "-0". The same bytes on every system.
[[nodiscard]] std::string number(double value, int decimals = 2);

/// The fewest digits that read back as the same float: 0.1, -12.7, 1e-7, 3.4028235e38; nan, inf, -inf.
[[nodiscard]] std::string shortest(float value);

/// "120 x 80.5 x 40"
[[nodiscard]] std::string dimensions(Vec3d size, int decimals = 1);

/// An integer with thin groups: 1,383,712
[[nodiscard]] std::string grouped(unsigned long long value);

/// "1 block", "3 blocks"
[[nodiscard]] std::string counted(unsigned long long count, std::string_view one, std::string_view many);

struct Quoted {
    [[nodiscard]] std::string operator()(std::string_view text, std::size_t longest = 40) const;
};
/// What stands in a file, made safe to show: as one_line() has it, cut off behind the last character within
/// `longest` bytes. No function, since std::quoted would be found beside it wherever a string is given.
inline constexpr Quoted quoted;

/// What stands between separators, which an empty text has none of.
[[nodiscard]] std::vector<std::string_view> words_between(std::string_view text, char separator);

}  // namespace snug
