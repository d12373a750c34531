#pragma once

namespace snug {

constexpr double kStandardGravity = 9.80665;  // m/s2

}  // namespace snug
