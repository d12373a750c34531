#include "snug/depth/streamed_surface.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/depth/depth_builder.h"

namespace snug {
namespace {

/// Where a group's box meets more columns than this, its triangles are looked at one by one.
constexpr int kMostColumns = 64;

/// Whether nothing within the placed box changes a depth.
bool changes_nothing(const DepthMapBuilder& builder, const Box3d& placed) {
    const CellRange j = builder.rows().meeting(placed.min.y, placed.max.y);
    const CellRange k = builder.columns().meeting(placed.min.z, placed.max.z);
    if ((j.last - j.first + 1) * (k.last - k.first + 1) > kMostColumns) return false;
    for (int row = j.first; row <= j.last; ++row)
        for (int column = k.first; column <= k.last; ++column) {
            const DepthRange& depth = builder.depths()(row, column);
            if (depth.lowest > placed.min.x || depth.highest < placed.max.x) return false;
        }
    return true;
}

void add_triangle(DepthMapBuilder& builder, const FileToObject& object, const Placement& placement,
                  const TriangleStream::Corners& corners) {
    std::array<Vec3d, 3> placed;
    std::array<VertexCell, 3> cells;
    for (std::size_t i = 0; i < 3; ++i) {
        placed[i] = placement(object(corners[i]));
        cells[i] = builder.add_vertex(placed[i]);
    }
    const bool one_cell = cells[0].one() && cells[0] == cells[1] && cells[0] == cells[2];
    if (!one_cell) builder.add_triangle(placed);
}

}  // namespace

Result<DepthMap> depth_map(const TriangleStream& stream, const FileToObject& object,
                           const Placement& placement, const DesignSpace& space, Reach reach, MetCubes* cubes,
                           const Progress& progress) {
    DepthMapBuilder whole(space, reach);
    std::vector<std::unique_ptr<DepthMapBuilder>> workers(worker_count());
    const auto done = stream.pass(
        [&](TriangleGroup piece, std::size_t worker) {
            if (!workers[worker]) workers[worker] = std::make_unique<DepthMapBuilder>(space, reach);
            DepthMapBuilder& own = *workers[worker];
            for_groups(piece, [&](TriangleGroup group) {
                const Box3d box = in_object(object, box_of(group));
                if (cubes != nullptr) mark_group(*cubes, object, group, box);
                if (changes_nothing(own, reached(placement.rotation, placement.shift, box))) return;
                for (const TriangleStream::Corners& corners : group)
                    add_triangle(own, object, placement, corners);
            });
        },
        progress);
    if (!done) return tl::unexpected(done.error());
    for (const auto& own : workers)
        if (own) whole.include(*own);
    return whole.take();
}

}  // namespace snug
