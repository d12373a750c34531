#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "snug/base/vec.h"
#include "snug/depth/depth_map.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// The rows and cells that vertices may lie in, for as many as are merged.
struct CellBounds {
    // Minima of the first and of the complements of the last: one kind of comparison merges all four.
    using Lanes [[gnu::vector_size(8)]] = std::int16_t;
    Lanes
        lanes;  ///< first row, first cell, ~last row, ~last cell; -1 and the count are cells beyond the grid

    [[nodiscard]] int first_j() const { return lanes[0]; }
    [[nodiscard]] int first_k() const { return lanes[1]; }
    [[nodiscard]] int last_j() const { return ~lanes[2]; }
    [[nodiscard]] int last_k() const { return ~lanes[3]; }
    [[nodiscard]] bool several() const {
        std::array<std::uint32_t, 2> halves;
        std::memcpy(&halves, &lanes, sizeof(halves));
        return halves[0] != ~halves[1];
    }
    [[nodiscard]] CellBounds merged(CellBounds other) const {
        return {lanes < other.lanes ? lanes : other.lanes};
    }
    /// The same with what lies beyond a grid, from `least` to `most` of each lane, replaced by its edge.
    [[nodiscard]] CellBounds clamped(Lanes least, Lanes most) const {
        const Lanes above = lanes > least ? lanes : least;
        return {above < most ? above : most};
    }
};

/// The vertices of one cluster, placed: x exactly, and which cells they lie in. The arrays are padded as the
/// cluster's vertices are.
struct PlacedCluster {
    static constexpr std::size_t kMost = SurfaceClusters::kVertices;
    static constexpr std::int32_t kUnsure = -1;

    std::array<double, kMost> x;  ///< the same bits as the placement gives
    /// The column (index in the depth map) whose cell, and no other, holds the vertex with all that rounding
    /// may do to it; else kUnsure.
    std::array<std::int32_t, kMost> column;
    /// The cells that may hold the vertex, alike: one each way where `column` is sure.
    std::array<CellBounds, kMost> cells;
    std::size_t padded = 0;
};

/// Places clusters and finds their columns, several vertices at a time.
class ClusterPlacer {
  public:
    static constexpr std::size_t kLanes = SurfaceClusters::kLanes;

    /// `slack`: more than the errors of float arithmetic and of crossings, mm.
    ClusterPlacer(const SurfaceClusters& surface, const Placement& placement, const DesignSpace& space,
                  Reach reach, double slack);

    /// Whether a vertex may lie in more than two cells along an axis: then columns and cells mean nothing.
    [[nodiscard]] bool cells_overlap_widely() const {
        return axes_[0].margin >= 0.5f || axes_[1].margin >= 0.5f;
    }

    /// x alone; its extremes.
    [[nodiscard]] DepthRange place_x(const SurfaceClusters::Cluster& cluster, PlacedCluster& out) const;
    /// Columns and cells, after place_x().
    void find_columns(const SurfaceClusters::Cluster& cluster, PlacedCluster& out) const;

    /// Vertex i of the cluster, exactly.
    [[nodiscard]] Vec3d vertex(const SurfaceClusters::Cluster& cluster, std::size_t i) const {
        const float* const x = surface_.coordinates.data() + cluster.first_coordinate + i;
        const std::size_t count = cluster.padded();
        return placement_(Vec3f{x[0], x[count], x[2 * count]});
    }

    /// One coordinate of it.
    [[nodiscard]] double coordinate(const SurfaceClusters::Cluster& cluster, std::size_t i, int axis) const {
        const float* const x = surface_.coordinates.data() + cluster.first_coordinate + i;
        const std::size_t count = cluster.padded();
        return dot(placement_.rotation.row[static_cast<std::size_t>(axis)],
                   vec_cast<double>(Vec3f{x[0], x[count], x[2 * count]})) +
               placement_.shift[axis];
    }

  private:
    /// y or z, counted in cells.
    struct Axis {
        Vec3f row;
        float shift, cells, margin;
    };

    const SurfaceClusters& surface_;
    Placement placement_;
    std::array<Axis, 2> axes_;
};

}  // namespace snug
