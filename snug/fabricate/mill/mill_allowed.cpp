#include "snug/fabricate/mill/mill_allowed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "snug/foam/object_cut.h"
#include "snug/space/available.h"

namespace snug {
namespace {

constexpr double kHeightRounding = 1e-6;  // of a step, for heights that are whole steps but for rounding

/// Steps of foam that may stand below the object, or above it seen from the lid.
int steps_below(const DepthRange& range, const Reach& reach, const DesignSpace& space, Half half,
                const MillField& field) {
    if (range.none()) return field.top;
    const double mm = half == Half::lower ? range.lowest - reach.mm.x - space.face(0, 0)
                                          : space.face(0, space.blocks.x) - (range.highest + reach.mm.x);
    return static_cast<int>(
        std::clamp(std::floor(mm / field.step_mm + kHeightRounding), 0.0, field.top * 1.0));
}

DesignSpace fine_space(DesignSpace space, const CarvedStock& stock) {
    space.blocks.y *= stock.rows_a_cell();
    space.blocks.z *= stock.columns_a_cell();
    space.block_mm.y /= stock.rows_a_cell();
    space.block_mm.z /= stock.columns_a_cell();
    return space;
}

/// What of each fine column lies within the case, if there is one, in blocks counted from the half's own
/// side.
Grid<Run> columns_within(const std::optional<MilledObject>& object, const DesignSpace& fine, Half half) {
    if (!object || !object->fitted_case) return all_blocks(fine.blocks);
    CaseSpace fitted = *object->fitted_case;
    fitted.space = fine;
    Grid<Run> within = available_blocks(fitted);
    if (half == Half::lid)
        for (Run& run : within)
            if (!run.none()) run = from_other_end(run, fine.blocks.x);
    return within;
}

/// Lowers each column to where an item allows it.
void keep_below(Grid<int>& steps, const ObjectDepths& depths, const DesignSpace& fine, Half half,
                const MillField& field) {
    const HalfDepths& own = half == Half::lower || !depths.upper ? depths.lower : *depths.upper;
    for (int j = 0; j < fine.blocks.y; ++j)
        for (int k = 0; k < fine.blocks.z; ++k)
            steps(j, k) = std::min(steps(j, k), steps_below(own.depths(j, k), own.reach, fine, half, field));
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
    const DesignSpace fine = fine_space(design.space, stock);
    const Grid<Run> within = columns_within(object, fine, half);
    Grid<int> below(fine.blocks.y, fine.blocks.z, field.top);
    for (const MilledSurface& surface : object->surfaces)
        keep_below(below, object_depths(surface.mesh, surface.placement, fine, surface.cut), fine, half,
                   field);
    for (int j = 0; j < fine.blocks.y; ++j)
        for (int k = 0; k < fine.blocks.z; ++k) {
            int& steps = allowed(mill_row(half, j, fine.blocks.y), k);
            // A column never stands higher than its object and its case allow; what is cut for other reasons
            // may stay.
            steps = std::max(steps, std::min(below(j, k), within(j, k).end * field.steps_a_block));
        }
    return allowed;
}

Grid<int> allowed_outside(const FoamDesign& design, Half half, const MillField& field,
                          const CarvedStock& stock, const std::optional<MilledObject>& object) {
    Grid<int> allowed = field_heights(field, stock);
    const DesignSpace fine = fine_space(design.space, stock);
    const Grid<Run> columns = columns_within(object, fine, half);
    const bool any_case = object && object->fitted_case;
    const Grid<Run>& kept = design.foams.piece(half);
    for (int j = 0; j < fine.blocks.y; ++j)
        for (int k = 0; k < fine.blocks.z; ++k) {
            int& steps = allowed(outside_row(half, j, fine.blocks.y), k);
            const Run within = columns(j, k);
            if (kept(j / stock.rows_a_cell(), k / stock.columns_a_cell()).none() &&
                (!any_case || within.none()))
                steps = field.top;
            else if (any_case)
                steps = std::max(steps, field.top - within.first * field.steps_a_block);
        }
    return allowed;
}

}  // namespace snug
