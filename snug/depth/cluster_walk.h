#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "snug/depth/box_reaches.h"
#include "snug/depth/crossed_triangles.h"
#include "snug/depth/depth_builder.h"
#include "snug/depth/placed_cluster.h"
#include "snug/object/prepared_surface.h"

namespace snug {

/// Adds a surface to a depth map, from the top of the hierarchy down. What lies in columns that hold lower
/// and higher points already is refused: a box of many clusters, a cluster, or a triangle. Only surely: the
/// depth map is exact whatever the order, and whatever it holds at the start.
class ClusterWalk {
  public:
    ClusterWalk(const SurfaceClusters& surface, const Placement& placement, const DesignSpace& space,
                Reach reach, DepthMapBuilder& builder);
    ClusterWalk(const ClusterWalk&) = delete;
    ClusterWalk& operator=(const ClusterWalk&) = delete;

    /// A few vertices from everywhere: the more the depth map holds, the more is refused.
    void add_samples();
    /// What lies in the boxes of a group (SurfaceClusters::levels).
    void add_group(std::size_t level, std::size_t group);

  private:
    using Cluster = SurfaceClusters::Cluster;
    struct Columns {
        int first_j, last_j, first_k, last_k;
    };
    struct Kept {
        const Cluster* cluster;
        Columns columns;
        DepthRange x;
    };

    void visit(std::size_t level, std::size_t group);
    [[nodiscard]] bool refused(double lowest, double highest, const Columns& columns) const;
    void fetch(std::size_t level, std::size_t box) const;
    void add_vertices(const Cluster& cluster, const Columns& columns);
    void add_kept_triangles();
    void add_plainly(const Cluster& cluster);

    // Triangles wait until the vertices of their neighbours are in the depth map as well.
    static constexpr std::size_t kMostKept = 16;

    const SurfaceClusters& surface_;
    Placement placement_;
    DepthMapBuilder& builder_;
    BoxPlacer boxes_;
    ClusterPlacer placer_;
    CrossedTriangles triangles_;
    bool cells_overlap_widely_;
    std::size_t kept_count_ = 0;
    std::array<Kept, kMostKept> kept_;
    std::array<PlacedCluster, kMostKept> placed_;
};

}  // namespace snug
