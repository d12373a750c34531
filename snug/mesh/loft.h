#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug {

using Ring = std::vector<Vec3d>;

/// Joins two rings of n vertices that the mesh has from those numbers on, the upper following the lower.
void join_rings(Mesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t n);

/// Appends rings of equally many points, joined in order; the first and last are closed by fans, unless all
/// their points are one. Each ring runs counter-clockwise seen from the next.
void add_loft(Mesh& mesh, std::span<const Ring> rings);

}  // namespace snug
