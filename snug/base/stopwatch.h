#pragma once

#include <chrono>
#include <utility>

namespace snug {

/// Measures how long stages take, for the timings in reports.
class Stopwatch {
  public:
    /// Milliseconds since the last call, or since the stopwatch was made.
    double lap() {
        const auto now = Clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace snug
