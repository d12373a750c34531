#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "snug/base/vec.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Neighbouring boxes of one level of a hierarchy, as floats side by side so that they are placed together.
/// A box holds what it bounds up to rounding, which those who use it allow for.
struct BoxGroup {
    static constexpr std::size_t kBoxes = 8;
    using Lanes = std::array<float, kBoxes>;
    std::array<Lanes, 3> centre{};
    std::array<Lanes, 3> half{};
};

struct BoxLevel {
    std::size_t boxes = 0;  ///< the last group may have room for more
    std::vector<BoxGroup> groups;
};

/// Triangles sorted along a space-filling curve and cut into clusters that lie close together, each with its
/// own copy of its vertices, below a hierarchy of boxes.
struct SurfaceClusters {
    static constexpr std::size_t kTriangles = 32;  ///< of a cluster, at most
    static constexpr std::size_t kLanes = 4;       ///< vertices of a cluster are padded to a multiple of this
    static constexpr std::size_t kVertices = (3 * kTriangles + kLanes - 1) / kLanes * kLanes;

    struct Cluster {
        std::uint32_t first_coordinate = 0;
        std::uint32_t first_triangle = 0;
        std::uint16_t vertices = 0;
        std::uint16_t triangles = 0;

        /// The last vertex is repeated up to a multiple of kLanes.
        [[nodiscard]] std::size_t padded() const { return (vertices + kLanes - 1) / kLanes * kLanes; }
    };

    /// Cluster after cluster: x of its vertices, then y, then z.
    std::vector<float> coordinates;
    std::vector<std::array<std::uint8_t, 3>> corners;  ///< of the triangles: vertices within their cluster
    std::vector<Cluster> clusters;
    /// levels[0] bounds the clusters, one box each; box i of levels[n + 1] bounds group i of levels[n]; the
    /// last level has one group.
    std::vector<BoxLevel> levels;
    std::vector<Vec3f> samples;  ///< one vertex of some clusters, spread evenly
    /// The largest coordinate: what the errors of float arithmetic are measured against.
    float largest = 0;
};

/// A mesh made ready for many placements. Gives the same depth maps and placements as the mesh itself, to the
/// bit, and much faster: most clusters are refused without a look at their triangles. Worth its making, which
/// takes about as long as reading the file, where more than a few placements follow.
struct PreparedSurface {
    SurfaceClusters body;
    SurfaceClusters caps;  ///< the triangles that use one of Mesh::cap_vertices
};

[[nodiscard]] PreparedSurface prepare_surface(const Mesh& mesh);

}  // namespace snug
