#include "snug/check/part_cut.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "snug/base/box.h"

namespace snug {
namespace {

/// A cell more on each side: crossings may be rounded to just outside a triangle.
CellRange widened(CellRange range, const GrownCells& cells) {
    return {std::max(range.first - 1, 0), std::min(range.last + 1, cells.count() - 1)};
}

}  // namespace

PartCut::PartCut(const Placement& placement, const DesignSpace& space, Reach reach)
    : placement_(placement), reach_(reach), along_x_(space, 0, {}), builder_(space, reach) {}

bool PartCut::cuts(const Mesh& part) {
    std::vector<std::uint32_t> all(part.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return cuts(part, all);
}

bool PartCut::cuts(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    Box3d box;
    for (const std::uint32_t t : triangles)
        for (const std::uint32_t v : mesh.triangles[t]) box.include(placement_(mesh.vertices[v]));
    // What lies wholly in a slot between two layers of blocks cuts none of them, however broad it is.
    if (!reaches_block(box.min.x, box.max.x)) return false;
    for (const std::uint32_t t : triangles) {
        std::array<Vec3d, 3> corners;
        std::array<VertexCell, 3> cells;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = placement_(mesh.vertices[mesh.triangles[t][i]]);
            cells[i] = builder_.add_vertex(corners[i]);
        }
        const bool one_cell = cells[0].one() && cells[0] == cells[1] && cells[0] == cells[2];
        if (!one_cell) builder_.add_triangle(corners);
    }
    return take_cut({widened(builder_.rows().meeting(box.min.y, box.max.y), builder_.rows()),
                     widened(builder_.columns().meeting(box.min.z, box.max.z), builder_.columns())});
}

bool PartCut::reaches_block(double lowest, double highest) const {
    const CellRange cut = along_x_.meeting(lowest - reach_.mm.x, highest + reach_.mm.x);
    return cut.first <= cut.last;
}

bool PartCut::take_cut(const ColumnBlock& block) {
    bool cut = false;
    for (int j = block.j.first; j <= block.j.last; ++j) {
        for (int k = block.k.first; k <= block.k.last; ++k) {
            DepthRange& depth = builder_.depths()(j, k);
            cut = cut || (!depth.none() && reaches_block(depth.lowest, depth.highest));
            depth = {};
        }
    }
    return cut;
}

}  // namespace snug
