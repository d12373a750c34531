#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/mesh/edges.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Welds ends of boundary edges that only rounding keeps apart, by less than a millionth of the object's
/// longest side: where a program computed a seam twice (sin 2 pi is not sin 0), the surface is closed all the
/// same. `weld` as made by welded(); says whether it changed.
[[nodiscard]] bool weld_seams(const Mesh& mesh, std::span<const BoundaryEdge> boundary,
                              std::vector<std::uint32_t>& weld);

}  // namespace snug
