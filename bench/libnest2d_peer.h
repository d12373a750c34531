#pragma once

#include <utility>
#include <vector>

namespace snug::bench {

/// x and y of its corners, once around.
using PeerOutline = std::vector<std::pair<double, double>>;

/// Whether libnest2d, as it is usually set, lays the hulls of all into one rectangle. `turns`: ways round
/// that a piece may have: 1, 2 (upside down) or 4. In C++17, which libnest2d needs.
bool libnest2d_holds(const std::vector<PeerOutline>& outlines, double width, double height, int turns);

}  // namespace snug::bench
