#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "snug/mesh/measure.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// A separate part, as people are told of it.
struct PartShare {
    std::size_t number = 0;  ///< from 1, in the order of MeshMeasure::parts
    std::size_t triangles = 0;
    Box3d bounds;
    double share = 0;  ///< of the surface's area
};
[[nodiscard]] std::vector<PartShare> part_shares(const Mesh& mesh, const MeshMeasure& measure);

/// The mesh without some of its parts; `drop` has an entry a part.
[[nodiscard]] Mesh without_parts(const Mesh& mesh, const MeshMeasure& measure, const std::vector<bool>& drop);

/// What lies before a plane: points p with dot(normal, p) >= distance, in the coordinates of the vertices.
/// Triangles are cut; both neighbours of an edge get the same corner on it, whatever way they are stored. The
/// openings that the plane makes are closed in it; what was open stays open. Empty where nothing is left. A
/// cloud loses its points behind the plane.
[[nodiscard]] Mesh cut_off(const Mesh& mesh, Vec3d normal, double distance);

}  // namespace snug
