#pragma once

namespace snug {

/// False for what is no number as well.
[[nodiscard]] constexpr bool within(double value, double least, double most) {
    return value >= least && value <= most;
}

}  // namespace snug
