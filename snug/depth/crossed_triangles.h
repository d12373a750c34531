#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "snug/depth/depth_builder.h"
#include "snug/depth/placed_cluster.h"
#include "snug/object/prepared_surface.h"

namespace snug {

/// Adds the triangles of placed clusters to a depth map whose vertices were added before: those that more
/// than one cell sees, where they may change anything.
class CrossedTriangles {
  public:
    /// `slack`: more than the errors of crossings, mm.
    CrossedTriangles(const SurfaceClusters& surface, const ClusterPlacer& placer, double slack,
                     DepthMapBuilder& builder);

    void add(const SurfaceClusters::Cluster& cluster, const PlacedCluster& placed);

    /// The columns of the grid within the bounds.
    [[nodiscard]] ColumnBlock block(CellBounds cells) const;

  private:
    /// A triangle of the cluster at hand.
    struct Corners {
        std::array<std::uint8_t, 3> vertex;  ///< within the cluster
        CellBounds cells;
        double x_min, x_max;  ///< all that crossings may have
    };

    /// 1 or 0: for sums without branches.
    [[nodiscard]] int changes(const Corners& t, std::size_t column) const {
        const DepthRange& depth = builder_.depths()[column];
        return (t.x_max > depth.highest) | (t.x_min < depth.lowest);
    }
    [[nodiscard]] bool may_change(const Corners& t) const;
    void add_beside_side(const SurfaceClusters::Cluster& cluster, const PlacedCluster& placed,
                         const Corners& t, const ColumnBlock& block);
    void add_around_corner(const SurfaceClusters::Cluster& cluster, const Corners& t,
                           const ColumnBlock& block);
    [[nodiscard]] std::array<Vec3d, 3> placed_corners(const SurfaceClusters::Cluster& cluster,
                                                      const Corners& t) const;

    const SurfaceClusters& surface_;
    const ClusterPlacer& placer_;
    DepthMapBuilder& builder_;
    double slack_;
    int rows_, cells_;
    CellBounds::Lanes least_, most_;  ///< of bounds within the grid
};

}  // namespace snug
