#pragma once

#include <cstdint>
#include <vector>

#include "snug/mesh/mesh.h"

namespace snug {

/// An edge that bounds the surface: an odd number of triangles use it. It runs from `from` to `to` as most of
/// them run through it.
struct BoundaryEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;

    friend bool operator==(const BoundaryEdge&, const BoundaryEdge&) = default;
};

/// What the edges of a mesh tell of its closedness. Triangles with two equal welded corners are left out.
struct EdgeCensus {
    bool watertight = false;             ///< there are edges, and each is used equally often each way
    std::vector<BoundaryEdge> boundary;  ///< sorted by the smaller end, then by the larger
};

/// `weld` as made by welded(); the ends of boundary edges are vertices of `weld`.
[[nodiscard]] EdgeCensus census_of_edges(const Mesh& mesh, const std::vector<std::uint32_t>& weld);

/// The boundary as loops that use every edge once and pass no vertex twice: each lists its vertices in order,
/// the last joins the first, three at least. Counted modulo 2 the boundary of any triangles meets every
/// vertex an even number of times, so such loops exist for every soup. A loop runs as most of its edges run;
/// where all triangles are wound alike, as all of them do. The same boundary gives the same loops.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> boundary_loops(
    const std::vector<BoundaryEdge>& boundary);

}  // namespace snug
