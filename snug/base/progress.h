#pragma once

#include <functional>

namespace snug {

/// Tells the caller how far long work has come (0 to 1) and asks whether to go on: false cancels.
/// An empty function means "go on, nobody listens".
using Progress = std::function<bool(double fraction)>;

[[nodiscard]] inline bool go_on(const Progress& progress, double fraction) {
    return !progress || progress(fraction);
}

/// What a part of the work tells, from `begin` to `end` of the whole.
[[nodiscard]] inline Progress part_of(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [&progress, begin, end](double fraction) { return progress(begin + (end - begin) * fraction); };
}

}  // namespace snug
