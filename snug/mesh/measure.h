#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "snug/base/box.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// For each vertex the smallest index of a vertex at the same position (bits compared, -0 = 0).
[[nodiscard]] std::vector<std::uint32_t> welded(const Mesh& mesh);

/// A connected part: triangles that share welded vertices.
struct MeshPart {
    std::size_t triangles = 0;
    Box3d bounds;  ///< relative to mesh.origin
    std::uint32_t first_triangle = 0;
};

/// What can be said of an object without placing it. Edges are those of welded vertices, seams included
/// (seams.h); triangles with two equal welded corners have none.
struct MeshMeasure {
    Box3d bounds;                  ///< relative to mesh.origin
    bool watertight = false;       ///< there are edges, each used equally often each way
    std::optional<double> volume;  ///< enclosed volume in cubed units of the mesh; none if open
    std::optional<Vec3d>
        centre;  ///< of the enclosed volume, in coordinates of the vertices; none if open or flat
    std::vector<MeshPart> parts;                  ///< largest bounding box (diagonal) first
    std::vector<std::uint32_t> part_of_triangle;  ///< index into parts
    std::vector<std::vector<std::uint32_t>>
        holes;  ///< boundary loops (see boundary_loops), vertices of welded()
};

/// Takes time linear in the size of the mesh. Every index must be in range.
[[nodiscard]] MeshMeasure measure(const Mesh& mesh);

}  // namespace snug
