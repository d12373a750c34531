#pragma once

#include <vector>

#include "snug/base/grid.h"
#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_shape.h"

namespace snug {

/// What is laid at a time: pieces of one kind on one height. `cells` and `supported`: (row, column) of studs.
struct BrickCourse {
    BrickKind kind = BrickKind::brick;
    int bottom = 0;        ///< plates below it
    Grid<char> cells;      ///< to be filled
    Grid<char> supported;  ///< of `cells`: on the table or on another course
    int unsupported = 0;   ///< cells that are not

    [[nodiscard]] int top() const { return bottom + (kind == BrickKind::brick ? kPlatesInBrick : 1); }
};

/// From below: each course stands on those before it. A tiled rim's top layer of bricks is two courses of
/// plates and one of tiles.
[[nodiscard]] std::vector<BrickCourse> brick_courses(const BrickShape& shape, BrickRim rim);

}  // namespace snug
