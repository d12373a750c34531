#pragma once

#include <algorithm>
#include <cstdint>

namespace snug {

/// The blocks first..end-1 of one column; none where first >= end.
struct Run {
    std::int16_t first = 0;
    std::int16_t end = 0;

    [[nodiscard]] bool none() const { return first >= end; }
    [[nodiscard]] int blocks() const { return none() ? 0 : end - first; }
    [[nodiscard]] bool contains(int block) const { return first <= block && block < end; }
    [[nodiscard]] Run common(Run other) const {
        return {std::max(first, other.first), std::min(end, other.end)};
    }
    /// Whether some block is in both.
    [[nodiscard]] bool meets(Run other) const { return !none() && !other.none() && !common(other).none(); }
    friend bool operator==(Run, Run) = default;
};

/// Counted from the other end of a column of `blocks` blocks.
[[nodiscard]] inline Run from_other_end(Run run, int blocks) {
    return {static_cast<std::int16_t>(blocks - run.end), static_cast<std::int16_t>(blocks - run.first)};
}

}  // namespace snug
