#pragma once

#include <cstddef>

#include "snug/mesh/mesh.h"

namespace snug {

/// A mesh with fewer triangles, for looking at, and how far it may lie from the original.
struct ThinMesh {
    Mesh mesh;
    /// No vertex moved by more, so no point of either surface is farther than this from the other. In the
    /// mesh's own unit; 0 if it is the original.
    double deviation = 0;
};

/// At most `most_triangles` (0 counts as 1), by clustering the vertices in cubes (Rossignac and Borrel,
/// Multi-resolution 3D approximations for rendering complex scenes, 1993). Triangles whose corners fall
/// together are left out where others cover their line or point, and kept without area where none do. The
/// same bytes everywhere.
[[nodiscard]] ThinMesh thinned(const Mesh& mesh, std::size_t most_triangles);

}  // namespace snug
