#include "snug/fabricate/mill_allowed.h"

#include <algorithm>
#include <cmath>

#include "snug/foam/object_cut.h"

namespace snug {
namespace {

constexpr double kRounding = 1e-6;  // of a step, for heights that are whole steps but for rounding

/// Steps of foam that may stand below the object, or above it seen from the lid.
int steps_below(const DepthRange& range, const Reach& reach, const DesignSpace& space, Half half,
                const MillField& field) {
    if (range.none()) return field.top;
    const double mm = half == Half::lower ? range.lowest - reach.mm.x - space.face(0, 0)
                                          : space.face(0, space.blocks.x) - (range.highest + reach.mm.x);
    return static_cast<int>(std::clamp(std::floor(mm / field.step_mm + kRounding), 0.0, field.top * 1.0));
}

}  // namespace

Grid<int> field_heights(const MillField& field, const CarvedStock& stock) {
    Grid<int> heights(stock.height().ny(), stock.height().nz());
    for (int row = 0; row < heights.ny(); ++row)
        for (int column = 0; column < heights.nz(); ++column)
            heights(row, column) = field.height(row / stock.rows_a_cell(), column / stock.columns_a_cell());
    return heights;
}

Grid<int> allowed_heights(const FoamDesign& design, Half half, const MillField& field,
                          const CarvedStock& stock, const std::optional<MilledObject>& object) {
    Grid<int> allowed = field_heights(field, stock);
    if (!object) return allowed;
    DesignSpace fine = design.space;
    fine.blocks.y *= stock.rows_a_cell();
    fine.blocks.z *= stock.columns_a_cell();
    fine.block_mm.y /= stock.rows_a_cell();
    fine.block_mm.z /= stock.columns_a_cell();
    const ObjectDepths depths = object_depths(object->mesh, object->placement, fine, object->cut);
    const HalfDepths& own = half == Half::lower || !depths.upper ? depths.lower : *depths.upper;
    for (int j = 0; j < fine.blocks.y; ++j)
        for (int k = 0; k < fine.blocks.z; ++k) {
            int& steps = allowed(mill_row(half, j, fine.blocks.y), k);
            // A column never stands higher than its object allows; what is cut for other reasons may stay.
            steps = std::max(steps, steps_below(own.depths(j, k), own.reach, fine, half, field));
        }
    return allowed;
}

}  // namespace snug
