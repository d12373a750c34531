#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug {

/// The triangles, given by their numbers, in the order of a space-filling curve (Morton) through their
/// centroids: neighbours in the list lie close together. Those at one place of the curve keep their order.
[[nodiscard]] std::vector<std::uint32_t> curve_order(const Mesh& mesh,
                                                     std::span<const std::uint32_t> triangles);

}  // namespace snug
