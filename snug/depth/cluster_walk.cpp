#include "snug/depth/cluster_walk.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

/// Boxes over more columns are not worth the look.
constexpr int kMostColumns = 64;
constexpr std::size_t kCacheLine = 64;

void fetch_bytes(const void* data, std::size_t size) {
    const char* const bytes = static_cast<const char*>(data);
    for (std::size_t at = 0; at < size; at += kCacheLine) __builtin_prefetch(bytes + at);
}

}  // namespace

ClusterWalk::ClusterWalk(const SurfaceClusters& surface, const Placement& placement, const DesignSpace& space,
                         Reach reach, DepthMapBuilder& builder)
    : surface_(surface),
      placement_(placement),
      builder_(builder),
      boxes_(surface, placement, space, reach),
      placer_(surface, placement, space, reach, boxes_.slack()),
      triangles_(surface, placer_, boxes_.slack(), builder),
      cells_overlap_widely_(placer_.cells_overlap_widely()) {}

void ClusterWalk::add_samples() {
    for (const Vec3f& vertex : surface_.samples) builder_.add_vertex(placement_(vertex));
}

void ClusterWalk::add_group(std::size_t level, std::size_t group) {
    visit(level, group);
    add_kept_triangles();
}

void ClusterWalk::visit(std::size_t level, std::size_t group) {
    const BoxLevel& boxes = surface_.levels[level];
    const std::size_t first = group * BoxGroup::kBoxes;
    const std::size_t count = std::min(BoxGroup::kBoxes, boxes.boxes - first);
    const BoxReaches reaches = boxes_(boxes.groups[group]);
    std::array<std::size_t, BoxGroup::kBoxes> open;
    std::size_t open_count = 0;
    const auto columns_of = [&reaches](std::size_t i) {
        return Columns{reaches.first_j[i], reaches.last_j[i], reaches.first_k[i], reaches.last_k[i]};
    };
    for (std::size_t i = 0; i < count; ++i) {
        if (refused(reaches.lowest[i], reaches.highest[i], columns_of(i))) continue;
        open[open_count++] = i;
        fetch(level, first + i);
    }
    for (std::size_t n = 0; n < open_count; ++n) {
        const std::size_t i = open[n];
        if (level > 0)
            visit(level - 1, first + i);
        else
            add_vertices(surface_.clusters[first + i], columns_of(i));
    }
}

bool ClusterWalk::refused(double lowest, double highest, const Columns& columns) const {
    const auto [first_j, last_j, first_k, last_k] = columns;
    if (first_j > last_j || first_k > last_k) return true;
    if ((last_j - first_j + 1) * (last_k - first_k + 1) > kMostColumns) return false;
    const DepthMap& depths = builder_.depths();
    for (int j = first_j; j <= last_j; ++j) {
        for (int k = first_k; k <= last_k; ++k) {
            const DepthRange& depth = depths(j, k);
            if (highest > depth.highest || lowest < depth.lowest) return false;
        }
    }
    return true;
}

/// Asks for the memory of what is looked at next; its first use would wait for it.
void ClusterWalk::fetch(std::size_t level, std::size_t box) const {
    if (level > 0) return fetch_bytes(&surface_.levels[level - 1].groups[box], sizeof(BoxGroup));
    const Cluster& cluster = surface_.clusters[box];
    fetch_bytes(&surface_.coordinates[cluster.first_coordinate], cluster.padded() * 3 * sizeof(float));
    fetch_bytes(&surface_.corners[cluster.first_triangle], cluster.triangles * sizeof(surface_.corners[0]));
}

void ClusterWalk::add_vertices(const Cluster& cluster, const Columns& columns) {
    if (cells_overlap_widely_) return add_plainly(cluster);
    PlacedCluster& placed = placed_[kept_count_];
    const DepthRange x = placer_.place_x(cluster, placed);
    if (refused(x.lowest - boxes_.slack(), x.highest + boxes_.slack(), columns)) return;
    placer_.find_columns(cluster, placed);
    DepthMap& depths = builder_.depths();
    std::int32_t differ = 0;
    for (std::size_t i = 0; i < cluster.vertices; ++i) {
        const std::int32_t column = placed.column[i];
        differ |= column ^ placed.column[0];
        if (column != PlacedCluster::kUnsure)
            depths[static_cast<std::size_t>(column)].include(placed.x[i]);
        else
            builder_.add_vertex(placer_.vertex(cluster, i), triangles_.block(placed.cells[i]));
    }
    const bool one_cell = differ == 0 && placed.column[0] != PlacedCluster::kUnsure;
    if (one_cell) return;
    kept_[kept_count_++] = {&cluster, columns, x};
    if (kept_count_ == kMostKept) add_kept_triangles();
}

void ClusterWalk::add_kept_triangles() {
    for (std::size_t i = 0; i < kept_count_; ++i) {
        const Kept& kept = kept_[i];
        const bool now_refused =
            refused(kept.x.lowest - boxes_.slack(), kept.x.highest + boxes_.slack(), kept.columns);
        if (!now_refused) triangles_.add(*kept.cluster, placed_[i]);
    }
    kept_count_ = 0;
}

/// Where a vertex may lie in many cells there is nothing to gain within a cluster.
void ClusterWalk::add_plainly(const Cluster& cluster) {
    std::array<Vec3d, SurfaceClusters::kVertices> placed;
    std::array<VertexCell, SurfaceClusters::kVertices> cells;
    for (std::size_t i = 0; i < cluster.vertices; ++i) {
        placed[i] = placer_.vertex(cluster, i);
        cells[i] = builder_.add_vertex(placed[i]);
    }
    for (std::size_t t = 0; t < cluster.triangles; ++t) {
        const auto& [a, b, c] = surface_.corners[cluster.first_triangle + t];
        const bool one_cell = cells[a].one() && cells[a] == cells[b] && cells[a] == cells[c];
        if (!one_cell) builder_.add_triangle({placed[a], placed[b], placed[c]});
    }
}

}  // namespace snug
