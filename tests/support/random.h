#pragma once

#include <cstdint>

namespace snug::test {

/// SplitMix64: the same numbers on every system, unlike the distributions of <random>.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// In [low, high], both included.
    int integer(int low, int high) {
        const std::int64_t count = std::int64_t{high} - low + 1;
        return static_cast<int>(low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(count)));
    }
    bool chance(double probability) { return unit() < probability; }

  private:
    std::uint64_t state_;
};

}  // namespace snug::test
