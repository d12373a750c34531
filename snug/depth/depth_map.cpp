#include "snug/depth/depth_map.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "snug/depth/add_in_parallel.h"
#include "snug/depth/depth_builder.h"
#include "snug/depth/large_triangles.h"

namespace snug {
namespace {

constexpr double kFaceTolerance = 0.01;
constexpr double kRounding = 1e-9;
constexpr std::size_t kLargeAtOnce = 256;  // triangles

}  // namespace

Reach reach(Vec3d clearance_mm, bool cut_on_touch) {
    Reach reach;
    for (int axis = 0; axis < 3; ++axis)
        reach.mm[axis] =
            (cut_on_touch ? clearance_mm[axis] : clearance_mm[axis] - kFaceTolerance) + kRounding;
    return reach;
}

DepthMap depth_map(const Mesh& mesh, const Placement& placement, const DesignSpace& space, Reach reach) {
    return depth_map(mesh, placement, space, reach, DepthMap(space.blocks.y, space.blocks.z));
}

DepthMap depth_map(const Mesh& mesh, const Placement& placement, const DesignSpace& space, Reach reach,
                   DepthMap known) {
    DepthMapBuilder builder(space, reach, std::move(known));
    std::vector<Vec3d> placed(mesh.vertices.size());
    std::vector<VertexCell> cells(mesh.vertices.size());
    add_in_parallel(builder, placed.size(), [&](DepthMapBuilder& own, std::size_t i) {
        placed[i] = placement(mesh.vertices[i]);
        cells[i] = own.add_vertex(placed[i]);
    });
    // Large triangles wait: by then much of what they would be looked at for is there.
    std::vector<std::uint8_t> waits;
    if (DepthTiles::pay(space.blocks.y, space.blocks.z)) waits.resize(mesh.triangles.size());
    add_in_parallel(builder, mesh.triangles.size(), [&](DepthMapBuilder& own, std::size_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const bool one_cell = cells[a].one() && cells[a] == cells[b] && cells[a] == cells[c];
        if (!one_cell && !own.add_small_triangle({placed[a], placed[b], placed[c]})) waits[t] = 1;
    });
    if (waits.empty()) return builder.take();
    const std::vector<std::uint32_t> large = outermost_first(mesh.triangles, waits, placed);
    add_in_parallel(
        builder, large.size(),
        [&](DepthMapBuilder& own, std::size_t i) {
            const auto& [a, b, c] = mesh.triangles[large[i]];
            own.add_triangle({placed[a], placed[b], placed[c]});
        },
        kLargeAtOnce);
    return builder.take();
}

}  // namespace snug
