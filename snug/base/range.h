#pragma once

#include <string>

#include "snug/base/text.h"

namespace snug {

/// False for what is no number as well.
[[nodiscard]] constexpr bool within(double value, double least, double most) {
    return value >= least && value <= most;
}

/// "the bed's width is 5 mm, but must be from 10 to 2000 mm"; `unit` with its space before it.
[[nodiscard]] inline std::string out_of_range(const std::string& what, double value, double least,
                                              double most, const std::string& unit = " mm") {
    return what + " is " + number(value, 4) + unit + ", but must be from " + number(least) + " to " +
           number(most) + unit;
}

}  // namespace snug
