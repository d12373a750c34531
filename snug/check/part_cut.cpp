#include "snug/check/part_cut.h"

#include <algorithm>
#include <numeric>

#include "snug/base/box.h"

namespace snug {
namespace {

constexpr int kRowsAtOnce = 8;

CellRange united(CellRange a, CellRange b) {
    return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

}  // namespace

PartCut::PartCut(const Placement& placement, const DesignSpace& space, Reach reach)
    : placement_(placement), reach_(reach), along_x_(space, 0, {}), builder_(space, reach) {}

std::optional<bool> PartCut::cuts(const Mesh& part) {
    std::vector<std::uint32_t> all(part.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return cuts(part, all);
}

std::optional<bool> PartCut::cuts(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    if (work_ > kMostWork) return {};
    std::vector<Placed> placed;
    Box3d box;
    CellRange rows{builder_.rows().count(), -1}, columns{builder_.columns().count(), -1};
    for (const std::uint32_t t : triangles) {
        const Triangle& triangle = mesh.triangles[t];
        const std::array<Vec3d, 3> corners{placement_(mesh.vertices[triangle[0]]),
                                           placement_(mesh.vertices[triangle[1]]),
                                           placement_(mesh.vertices[triangle[2]])};
        for (const Vec3d& corner : corners) box.include(corner);
        const ColumnBlock met = builder_.met_by(corners);
        if (met.j.first > met.j.last || met.k.first > met.k.last) continue;
        rows = united(rows, met.j);
        columns = united(columns, met.k);
        placed.push_back({corners, met});
    }
    // What lies wholly in a slot between two layers of blocks cuts none of them, however broad it is.
    if (!reaches_block(box.min.x, box.max.x)) return false;
    // A few rows at a time: what cuts a block mostly cuts one in the first of them.
    for (int row = rows.first; row <= rows.last; row += kRowsAtOnce) {
        const CellRange strip{row, std::min(row + kRowsAtOnce - 1, rows.last)};
        for (const Placed& triangle : placed) add(triangle, strip);
        if (take_cut({strip, columns})) return true;
        if (work_ > kMostWork) return {};
    }
    return false;
}

void PartCut::add(const Placed& triangle, CellRange rows) {
    const CellRange j{std::max(triangle.met.j.first, rows.first), std::min(triangle.met.j.last, rows.last)};
    ++work_;
    if (j.first > j.last) return;
    const ColumnBlock block{j, triangle.met.k};
    work_ += block.k.last - block.k.first + 1;
    for (const Vec3d& corner : triangle.corners) builder_.add_vertex(corner, block);
    builder_.add_edges_within(triangle.corners, block);
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
    work_ += static_cast<long long>(block.j.last - block.j.first + 1) * (block.k.last - block.k.first + 1);
    return cut;
}

}  // namespace snug
