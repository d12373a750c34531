#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "snug/base/vec.h"

// Values as report.json shows them.

namespace snug {

/// Rounded to a nanometre, or to another fraction, so that the text shows no noise.
[[nodiscard]] inline double rounded(double value, double digits = 1e6) {
    return std::floor(value * digits + 0.5) / digits;
}

template <class T>
[[nodiscard]] nlohmann::ordered_json array(Vec3<T> v) {
    using Json = nlohmann::ordered_json;
    if constexpr (std::is_floating_point_v<T>) return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)});
    return Json::array({v.x, v.y, v.z});
}

[[nodiscard]] inline nlohmann::ordered_json or_null(const std::optional<double>& value, double digits) {
    return value ? nlohmann::ordered_json(rounded(*value, digits)) : nlohmann::ordered_json(nullptr);
}

}  // namespace snug
