#pragma once

#include <functional>

namespace snug {

/// Tells the caller how far long work has come (0 to 1) and asks whether to go on: false cancels.
/// An empty function means "go on, nobody listens".
using Progress = std::function<bool(double fraction)>;

[[nodiscard]] inline bool go_on(const Progress& progress, double fraction) {
    return !progress || progress(fraction);
}

}  // namespace snug
