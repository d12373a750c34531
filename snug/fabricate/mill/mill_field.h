#pragma once

#include "snug/base/grid.h"
#include "snug/base/piece.h"
#include "snug/base/vec2.h"
#include "snug/fabricate/kit/workshop_pack.h"

// What is milled, as the machine sees it: x to the right, y away from the operator, z up, the origin at the
// near left corner of the stock's underside; mm. The half lies cavity up: the lower foam with BACK away from
// the operator, the lid with BACK near; k runs to the right in both.

namespace snug {

constexpr double kCutterTouch = 1e-7;  ///< mm by which a cutter may seem to enter what it only touches

/// Heights that are to be left, as (row, column) of columns: row 0 is the nearest, column 0 the leftmost.
struct MillField {
    Grid<int> height;    ///< in steps above the underside, 0 to `top`
    Vec2d cell_mm;       ///< x and y
    double step_mm = 1;  ///< what one pass goes down at most; divides the block depth
    int top = 0;         ///< of the stock, in steps
    int steps_a_block = 1;

    [[nodiscard]] Vec2d size_mm() const { return {cell_mm.x * height.nz(), cell_mm.y * height.ny()}; }
    [[nodiscard]] double top_mm() const { return top * step_mm; }
    [[nodiscard]] int lowest() const;
};

/// The piece from its cavity's side; the stock is as thick as its highest column. Passes go down by the
/// greatest part of a block that is no more than `step_down_mm`.
[[nodiscard]] MillField mill_field(const FoamDesign& design, Piece piece, double step_down_mm);

/// The same piece from its other side, after the stock was turned over about its long axis (x): what a case
/// with rounded corners or leaning walls leaves out there, or the cavities of the layer below. Nothing is to
/// be milled where nothing is left out.
[[nodiscard]] MillField mill_outside(const FoamDesign& design, Piece piece, double step_down_mm);

/// Row (from the operator) of the columns j of the design.
[[nodiscard]] inline int mill_row(Half half, int j, int ny) {
    return half == Half::lower ? ny - 1 - j : j;
}
/// The same after the half was turned over about x: near and far change places.
[[nodiscard]] inline int outside_row(Half half, int j, int ny) {
    return ny - 1 - mill_row(half, j, ny);
}

}  // namespace snug
