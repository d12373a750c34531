#include "snug/depth/placed_cluster.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace snug {

// The loops below are written so that compilers turn them into vector code: flat, with pointers that do not
// alias, and conditions as selections between numbers of one width that are there already.

ClusterPlacer::ClusterPlacer(const SurfaceClusters& surface, const Placement& placement,
                             const DesignSpace& space, Reach reach, double slack)
    : surface_(surface), placement_(placement) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const int axis = static_cast<int>(i) + 1;
        const double per_mm = 1 / space.block_mm[axis];
        axes_[i] = {vec_cast<float>(placement.rotation.row[i + 1] * per_mm),
                    static_cast<float>((placement.shift[axis] - space.face(axis, 0)) * per_mm),
                    static_cast<float>(space.blocks[axis]),
                    static_cast<float>((std::fabs(reach.mm[axis]) + 2 * slack) * per_mm)};
    }
}

DepthRange ClusterPlacer::place_x(const SurfaceClusters::Cluster& cluster, PlacedCluster& out) const {
    // The same operations in the same order as Placement, so that the bits are the same.
    const Vec3d row = placement_.rotation.row[0];
    const double shift = placement_.shift.x;
    const std::size_t count = out.padded = cluster.padded();
    const float* const x = surface_.coordinates.data() + cluster.first_coordinate;
    const float* const y = x + count;
    const float* const z = y + count;
    double* const __restrict placed = out.x.data();
    for (std::size_t i = 0; i < count; ++i)
        placed[i] = row.x * static_cast<double>(x[i]) + row.y * static_cast<double>(y[i]) +
                    row.z * static_cast<double>(z[i]) + shift;

    std::array<double, kLanes> low, high;
    for (std::size_t lane = 0; lane < kLanes; ++lane) low[lane] = high[lane] = placed[lane];
    for (std::size_t i = kLanes; i < count; i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            low[lane] = std::min(low[lane], placed[i + lane]);
            high[lane] = std::max(high[lane], placed[i + lane]);
        }
    }
    DepthRange range;
    for (std::size_t lane = 0; lane < kLanes; ++lane) range.include(DepthRange{low[lane], high[lane]});
    return range;
}

void ClusterPlacer::find_columns(const SurfaceClusters::Cluster& cluster, PlacedCluster& out) const {
    const Axis row = axes_[0], cell = axes_[1];
    const std::size_t count = out.padded;
    const float* const x = surface_.coordinates.data() + cluster.first_coordinate;
    const float* const y = x + count;
    const float* const z = y + count;
    std::int32_t* const __restrict columns = out.column.data();
    std::array<std::int32_t, PlacedCluster::kMost> firsts, lasts;
    for (std::size_t i = 0; i < count; ++i) {
        // What lies outside the grid is put on its edge, which is near a bound.
        const float j_any = row.row.x * x[i] + row.row.y * y[i] + row.row.z * z[i] + row.shift;
        const float k_any = cell.row.x * x[i] + cell.row.y * y[i] + cell.row.z * z[i] + cell.shift;
        const float j_above = std::max(j_any, 0.0f);
        const float k_above = std::max(k_any, 0.0f);
        const float j = std::min(j_above, row.cells);
        const float k = std::min(k_above, cell.cells);
        // One more than the cell, so that nothing is rounded below zero.
        const std::int32_t first_j = static_cast<std::int32_t>(j + 1 - row.margin);
        const std::int32_t first_k = static_cast<std::int32_t>(k + 1 - cell.margin);
        const std::int32_t last_j = static_cast<std::int32_t>(j + 1 + row.margin);
        const std::int32_t last_k = static_cast<std::int32_t>(k + 1 + cell.margin);
        firsts[i] = ((first_j - 1) & 0xffff) | (first_k - 1) << 16;
        lasts[i] = (-last_j & 0xffff) | -last_k << 16;
        const float sure_j = static_cast<float>(first_j - 1);
        const float sure_k = static_cast<float>(first_k - 1);
        // An index is below 2 to the 24, so exact in float.
        const std::int32_t index = static_cast<std::int32_t>(sure_j * cell.cells + sure_k);
        const std::int32_t differ = (first_j ^ last_j) | (first_k ^ last_k);
        columns[i] = differ == 0 ? index : PlacedCluster::kUnsure;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<std::int32_t, 2> both{firsts[i], lasts[i]};
        std::memcpy(&out.cells[i], &both, sizeof(both));
    }
}

}  // namespace snug
