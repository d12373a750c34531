#pragma once

#include <cstdint>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug {

/// Triangles that span the boundary loops of an open mesh (MeshMeasure::holes): a fan from each loop's
/// centroid, which covers every point that the loop runs around, seen from anywhere, whatever its shape.
/// Wound as the triangles around the loop are. Vertex order within the result is its own; the result has
/// mesh.origin.
[[nodiscard]] Mesh span_of_loops(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& loops);

/// The mesh with its loops closed, its own vertices and triangles first and unchanged. Each loop gets its
/// fan, which makes a consistently wound mesh watertight. The base that a scan lacks also reaches above and
/// below the fan of a wavy rim, so a nearly flat loop gets a closed prism too: over its outline, from the
/// lowest of its vertices to the highest along its normal, and on to the object's own end where that is near
/// (a tenth of the loop's size), since what stands on a table has no base below it. What the missing surface
/// did beyond that nothing tells. Loops that are far from flat, such as cracks around a bulge, get the fan
/// alone: a prism over them would cut what the object never filled.
[[nodiscard]] Mesh capped(const Mesh& mesh, const std::vector<std::vector<std::uint32_t>>& loops);

}  // namespace snug
