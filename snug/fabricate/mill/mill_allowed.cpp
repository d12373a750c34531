#include "snug/fabricate/mill/mill_allowed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "snug/foam/object_cut.h"
#include "snug/space/available.h"

namespace snug {
namespace {

constexpr double kHeightRounding = 1e-6;  // of a step, for heights that are whole steps but for rounding

/// Which side of a piece is looked at: foam grows from `base_mm` (x) towards the items that it must not meet,
/// which are above it or below it.
struct WorkedSide {
    Piece piece;
    bool items_above = true;
    double base_mm = 0;

    /// Layer 1 lies on piece 0.
    [[nodiscard]] bool meets(int layer) const { return items_above == (layer > piece.index); }
};

WorkedSide cavity_side(const FoamDesign& design, Piece piece) {
    const int nx = design.space.blocks.x;
    const bool lid = piece.half() == Half::lid;
    return {piece, !lid, design.space.face(0, lid ? nx : design.seen(piece).under)};
}

WorkedSide other_side(const FoamDesign& design, Piece piece, const MillField& field) {
    return {piece, false, design.space.face(0, design.seen(piece).under) + field.top_mm()};
}

/// Steps of foam that may stand before an item.
int steps_before(const DepthRange& range, const Reach& reach, const WorkedSide& side,
                 const MillField& field) {
    if (range.none()) return field.top;
    const double mm = side.items_above ? range.lowest - reach.mm.x - side.base_mm
                                       : side.base_mm - (range.highest + reach.mm.x);
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

/// What of each fine column lies within the case, if there is one, in blocks counted as seen_piece() does.
Grid<Run> columns_within(const std::optional<MilledObject>& object, const DesignSpace& fine, Piece piece,
                         int under) {
    if (!object || !object->fitted_case) return all_blocks(fine.blocks);
    CaseSpace fitted = *object->fitted_case;
    fitted.space = fine;
    Grid<Run> within = available_blocks(fitted);
    for (Run& run : within) {
        if (run.none()) continue;
        if (piece.half() == Half::lid) run = from_other_end(run, fine.blocks.x);
        run = {static_cast<std::int16_t>(run.first - under), static_cast<std::int16_t>(run.end - under)};
    }
    return within;
}

/// The steps that the items allow in each fine column of the design.
Grid<int> steps_beside(const MilledObject& object, const DesignSpace& fine, const WorkedSide& side,
                       const MillField& field) {
    Grid<int> steps(fine.blocks.y, fine.blocks.z, field.top);
    for (const MilledSurface& surface : object.surfaces) {
        if (!side.meets(surface.layer)) continue;
        const ObjectDepths depths = object_depths(surface.mesh, surface.placement, fine, surface.cut);
        const HalfDepths& own = side.items_above || !depths.upper ? depths.lower : *depths.upper;
        for (int j = 0; j < fine.blocks.y; ++j)
            for (int k = 0; k < fine.blocks.z; ++k)
                steps(j, k) = std::min(steps(j, k), steps_before(own.depths(j, k), own.reach, side, field));
    }
    return steps;
}

}  // namespace

Grid<int> field_heights(const MillField& field, const CarvedStock& stock) {
    Grid<int> heights(stock.height().ny(), stock.height().nz());
    for (int row = 0; row < heights.ny(); ++row)
        for (int column = 0; column < heights.nz(); ++column)
            heights(row, column) = field.height(row / stock.rows_a_cell(), column / stock.columns_a_cell());
    return heights;
}

Grid<int> allowed_heights(const FoamDesign& design, Piece piece, const MillField& field,
                          const CarvedStock& stock, const std::optional<MilledObject>& object) {
    Grid<int> allowed = field_heights(field, stock);
    if (!object) return allowed;
    const DesignSpace fine = fine_space(design.space, stock);
    const Grid<Run> within = columns_within(object, fine, piece, design.seen(piece).under);
    const Grid<int> beside = steps_beside(*object, fine, cavity_side(design, piece), field);
    const Grid<Run>& kept = design.foams.piece(piece);
    for (int j = 0; j < fine.blocks.y; ++j)
        for (int k = 0; k < fine.blocks.z; ++k) {
            int& steps = allowed(mill_row(piece.half(), j, fine.blocks.y), k);
            // What stands through a piece from the layer below is not looked at from above.
            if (piece.middle() && kept(j / stock.rows_a_cell(), k / stock.columns_a_cell()).none()) continue;
            // A column never stands higher than its object and its case allow; what is cut for other reasons
            // may stay.
            steps = std::max(steps, std::min(beside(j, k), within(j, k).end * field.steps_a_block));
        }
    return allowed;
}

Grid<int> allowed_outside(const FoamDesign& design, Piece piece, const MillField& field,
                          const CarvedStock& stock, const std::optional<MilledObject>& object) {
    Grid<int> allowed = field_heights(field, stock);
    const DesignSpace fine = fine_space(design.space, stock);
    const Grid<Run> columns = columns_within(object, fine, piece, design.seen(piece).under);
    const bool any_case = object && object->fitted_case;
    const bool middle = object && piece.middle();
    const Grid<int> beside = middle ? steps_beside(*object, fine, other_side(design, piece, field), field)
                                    : Grid<int>(fine.blocks.y, fine.blocks.z, field.top);
    const Grid<Run>& kept = design.foams.piece(piece);
    for (int j = 0; j < fine.blocks.y; ++j)
        for (int k = 0; k < fine.blocks.z; ++k) {
            int& steps = allowed(outside_row(piece.half(), j, fine.blocks.y), k);
            const Run within = columns(j, k);
            if (kept(j / stock.rows_a_cell(), k / stock.columns_a_cell()).none() &&
                (!any_case || within.none()))
                steps = field.top;
            else if (any_case || middle)
                steps = std::max(steps, std::min(beside(j, k), field.top - std::max<int>(0, within.first) *
                                                                               field.steps_a_block));
        }
    return allowed;
}

}  // namespace snug
