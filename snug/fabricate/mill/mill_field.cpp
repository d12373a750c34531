#include "snug/fabricate/mill/mill_field.h"

#include <algorithm>
#include <cmath>

namespace snug {
namespace {

constexpr double kStepRounding = 1e-9;  // of a step that divides a block but for rounding

/// All at the bottom, below a top where the highest of the kept runs ends.
MillField empty_field(const FoamDesign& design, const Grid<Run>& kept, double step_down_mm) {
    const Vec3d block = design.space.block_mm;
    MillField field;
    field.height = Grid<int>(kept.ny(), kept.nz());
    field.cell_mm = {block.z, block.y};
    field.steps_a_block = static_cast<int>(std::ceil(block.x / step_down_mm - kStepRounding));
    field.step_mm = block.x / field.steps_a_block;
    for (const Run run : kept) field.top = std::max(field.top, run.end * field.steps_a_block);
    return field;
}

}  // namespace

int MillField::lowest() const {
    return *std::min_element(height.begin(), height.end());
}

MillField mill_field(const FoamDesign& design, Piece piece, double step_down_mm) {
    const Grid<Run> kept = design.seen(piece).kept;
    MillField field = empty_field(design, kept, step_down_mm);
    for (int j = 0; j < kept.ny(); ++j)
        for (int k = 0; k < kept.nz(); ++k)
            field.height(mill_row(piece.half(), j, kept.ny()), k) = kept(j, k).end * field.steps_a_block;
    return field;
}

MillField mill_outside(const FoamDesign& design, Piece piece, double step_down_mm) {
    const Grid<Run> kept = design.seen(piece).kept;
    MillField field = empty_field(design, kept, step_down_mm);
    field.height = Grid<int>(field.height.ny(), field.height.nz(), field.top);
    const int ny = kept.ny();
    for (int j = 0; j < ny; ++j)
        for (int k = 0; k < kept.nz(); ++k)
            field.height(outside_row(piece.half(), j, ny), k) -= kept(j, k).first * field.steps_a_block;
    // Where the cavity's side took all foam the cutter goes through air, or what is left out beside it would
    // be a slot.
    const int lowest = field.lowest();
    for (int j = 0; j < ny; ++j)
        for (int k = 0; k < kept.nz(); ++k)
            if (kept(j, k).none()) field.height(outside_row(piece.half(), j, ny), k) = lowest;
    return field;
}

}  // namespace snug
