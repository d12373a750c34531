#pragma once

#include <algorithm>
#include <cstdlib>

namespace snug::test {

/// How many random cases a test looks at: `all`, or of them the share that SNUG_CASES is of 2000, but no
/// fewer than `least`. Under sanitizers each takes ten times as long, so scripts/test looks at a fifth there:
/// enough to go through all the code, while g++ looks at all, and scripts/soak at all under sanitizers and at
/// many more with g++.
[[nodiscard]] inline int cases(int all, int least = 1) {
    const char* text = std::getenv("SNUG_CASES");
    return text ? std::max(std::min(least, all), static_cast<int>(1LL * all * std::atoi(text) / 2000)) : all;
}

/// The same of what has no more than `all`, such as the sizes that a test of speed takes.
[[nodiscard]] inline int cases_at_most(int all, int least = 1) {
    return std::min(all, cases(all, least));
}

}  // namespace snug::test
