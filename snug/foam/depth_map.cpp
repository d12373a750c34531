#include "snug/foam/depth_map.h"

#include <cstdint>
#include <vector>

#include "snug/foam/add_in_parallel.h"
#include "snug/foam/depth_builder.h"
#include "snug/foam/large_triangles.h"

namespace snug {
namespace {

constexpr double kFaceTolerance = 0.01;
constexpr double kRounding = 1e-9;

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
    add_in_parallel(builder, placed.size(), [&](DepthMapBuilder& own, std::size_t i) {
        placed[i] = placement(mesh.vertices[i]);
        cells[i] = own.add_vertex(placed[i]);
    });
    const auto add = [&](DepthMapBuilder& own, const Triangle& triangle) {
        const auto& [a, b, c] = triangle;
        const bool one_cell = cells[a].one() && cells[a] == cells[b] && cells[a] == cells[c];
        if (!one_cell) own.add_triangle({placed[a], placed[b], placed[c]});
    };
    const std::vector<std::uint32_t> large = large_triangles(mesh.triangles, placed, space);
    add_in_parallel(builder, large.size(),
                    [&](DepthMapBuilder& own, std::size_t i) { add(own, mesh.triangles[large[i]]); });
    add_in_parallel(builder, mesh.triangles.size(), [&](DepthMapBuilder& own, std::size_t t) {
        if (large.empty() || !is_large(mesh.triangles[t], placed, space)) add(own, mesh.triangles[t]);
    });
    return builder.take();
}

}  // namespace snug
