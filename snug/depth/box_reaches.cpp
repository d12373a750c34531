#include "snug/depth/box_reaches.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

constexpr std::size_t kBoxes = BoxGroup::kBoxes;

void first_cells(const BoxGroup::Lanes& from, float cells, BoxReaches::Cells& first) {
    // Truncation rounds up below zero, where the first cell is meant anyway. What begins beyond the last
    // cell gets one that is none.
    for (std::size_t i = 0; i < kBoxes; ++i) {
        const float cell = from[i] > 0 ? from[i] : 0;
        first[i] = static_cast<int>(cell < cells ? cell : cells);
    }
}

void last_cells(const BoxGroup::Lanes& to, float cells, BoxReaches::Cells& last) {
    for (std::size_t i = 0; i < kBoxes; ++i) {
        const float cell = to[i] + 1 <= 0 ? 0 : to[i] + 1;
        last[i] = static_cast<int>(cell < cells ? cell : cells) - 1;
    }
}

}  // namespace

BoxPlacer::BoxPlacer(const SurfaceClusters& surface, const Placement& placement, const DesignSpace& space,
                     Reach reach) {
    const Vec3d half_space = space.size() * 0.5;
    double size = 3.0 * surface.largest + std::max({half_space.x, half_space.y, half_space.z});
    for (int axis = 0; axis < 3; ++axis) size += std::fabs(placement.shift[axis]);
    // About 30 roundings of numbers up to `size`; the constant is for the crossings.
    slack_ = static_cast<float>(2e-6 * size + 1e-9);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const bool in_cells = axis > 0;
        const double scale = in_cells ? 1 / space.block_mm[axis] : 1;
        const double start = in_cells ? space.face(axis, 0) : 0;
        const Vec3d row = placement.rotation.row[i] * scale;
        row_[i] = {static_cast<float>(row.x), static_cast<float>(row.y), static_cast<float>(row.z)};
        shift_[i] = static_cast<float>((placement.shift[axis] - start) * scale);
        grow_[i] = static_cast<float>((slack_ + (in_cells ? std::max(reach.mm[axis], 0.0) : 0)) * scale);
        cells_[i] = static_cast<float>(space.blocks[axis]);
    }
}

BoxReaches BoxPlacer::operator()(const BoxGroup& group) const {
    BoxReaches reaches;
    std::array<BoxGroup::Lanes, 3> min, max;
    const auto& [cx, cy, cz] = group.centre;
    const auto& [hx, hy, hz] = group.half;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [x, y, z] = row_[axis];
        const float ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
        for (std::size_t i = 0; i < kBoxes; ++i) {
            const float centre = x * cx[i] + y * cy[i] + z * cz[i] + shift_[axis];
            const float half = ax * hx[i] + ay * hy[i] + az * hz[i] + grow_[axis];
            min[axis][i] = centre - half;
            max[axis][i] = centre + half;
        }
    }
    reaches.lowest = min[0];
    reaches.highest = max[0];
    first_cells(min[1], cells_[1], reaches.first_j);
    last_cells(max[1], cells_[1], reaches.last_j);
    first_cells(min[2], cells_[2], reaches.first_k);
    last_cells(max[2], cells_[2], reaches.last_k);
    return reaches;
}

}  // namespace snug
