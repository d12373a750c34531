#pragma once

#include <string>
#include <vector>

#include "snug/base/half.h"
#include "snug/design/brick_parts.h"

// Foam halves as bricks. A half stands cavity up, as it is built: rows and columns of studs as it is seen
// from above, row 0 at the far side and column 0 at the left (the lower foam's far side is BACK, the lid's
// near one); heights in plates of 3.2 mm from the half's floor.

namespace snug {

/// One piece in its place.
struct Brick {
    BrickKind kind = BrickKind::brick;
    int row = 0, column = 0;    ///< of its far left stud
    int rows = 1, columns = 1;  ///< studs towards the viewer and to the right
    int bottom = 0;             ///< plates below it

    [[nodiscard]] int height() const { return kind == BrickKind::brick ? kPlatesInBrick : 1; }
    [[nodiscard]] int top() const { return bottom + height(); }
    [[nodiscard]] int studs() const { return rows * columns; }
    [[nodiscard]] bool has_studs() const { return kind != BrickKind::tile; }
    friend bool operator==(const Brick&, const Brick&) = default;
};

/// In a sentence.
[[nodiscard]] inline std::string half_name(Half half) {
    return half == Half::lower ? "lower half" : "lid";
}

/// One half, its bricks in the order of building: each rests on the table or on a brick before it.
struct BrickBuild {
    Half half = Half::lower;
    int rows = 0, columns = 0;  ///< studs of the whole half
    std::vector<Brick> bricks;
};

/// Two bricks that hold each other by studs: `upper` stands on `lower`; the rectangle of common studs.
struct BrickJoint {
    int lower = 0, upper = 0;  ///< numbers in BrickBuild::bricks
    int row = 0, column = 0, rows = 0, columns = 0;
};

/// Every pair that holds, in the order of the upper brick, then of the lower one. Tiles hold nothing above.
[[nodiscard]] std::vector<BrickJoint> brick_joints(const BrickBuild& build);

}  // namespace snug
