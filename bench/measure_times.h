#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include <nlohmann/json.hpp>

namespace snug::bench {

/// Milliseconds of one call.
template <class Work>
double time_of(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Median and spread, as the report has them.
inline nlohmann::json summary(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[std::min(values.size() - 1,
                               static_cast<std::size_t>(share * static_cast<double>(values.size())))];
    };
    return {{"median", at(0.5)}, {"low", at(0.25)}, {"high", at(0.75)}, {"count", values.size()}};
}

}  // namespace snug::bench
