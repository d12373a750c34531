#include "snug/foam/depth_map.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "snug/base/parallel.h"
#include "snug/foam/depth_builder.h"

namespace snug {
namespace {

constexpr double kFaceTolerance = 0.01;
constexpr double kRounding = 1e-9;
constexpr std::size_t kChunk = std::size_t{1} << 14;  // vertices or triangles that one task treats

/// Adds items 0 to count - 1 with add(builder, item). Each worker fills a depth map of its own: extremes of
/// extremes are the same whatever each got.
template <class Add>
void add_all(DepthMapBuilder& builder, std::size_t count, Add add) {
    const std::size_t chunks = (count + kChunk - 1) / kChunk;
    const auto add_chunk = [&](DepthMapBuilder& own, std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * kChunk);
        for (std::size_t item = chunk * kChunk; item < end; ++item) add(own, item);
    };
    if (worker_count() == 1 || chunks < 2) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) add_chunk(builder, chunk);
        return;
    }
    std::vector<std::unique_ptr<DepthMapBuilder>> workers(worker_count());
    parallel_for_workers(chunks, [&](std::size_t chunk, std::size_t worker) {
        if (!workers[worker]) workers[worker] = std::make_unique<DepthMapBuilder>(builder);
        add_chunk(*workers[worker], chunk);
    });
    for (const auto& own : workers)
        if (own) builder.include(*own);
}

}  // namespace

Reach reach(Vec3d clearance_mm, bool cut_on_touch) {
    Reach reach;
    for (int axis = 0; axis < 3; ++axis)
        reach.mm[axis] =
            (cut_on_touch ? clearance_mm[axis] : clearance_mm[axis] - kFaceTolerance) + kRounding;
    return reach;
}

DepthMap depth_map(const Mesh& mesh, const Placement& placement, const DesignSpace& space, Reach reach) {
    DepthMapBuilder builder(space, reach);
    std::vector<Vec3d> placed(mesh.vertices.size());
    std::vector<VertexCell> cells(mesh.vertices.size());
    add_all(builder, placed.size(), [&](DepthMapBuilder& own, std::size_t i) {
        placed[i] = placement(mesh.vertices[i]);
        cells[i] = own.add_vertex(placed[i]);
    });
    add_all(builder, mesh.triangles.size(), [&](DepthMapBuilder& own, std::size_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const bool one_cell = cells[a].one() && cells[a] == cells[b] && cells[a] == cells[c];
        if (!one_cell) own.add_triangle({placed[a], placed[b], placed[c]});
    });
    return builder.take();
}

}  // namespace snug
