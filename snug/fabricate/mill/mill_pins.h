#pragma once

#include <span>
#include <vector>

#include "snug/fabricate/mill/mill_field.h"

namespace snug {

/// A blind hole from the cavity's side, x and y as the half is milled.
struct MillPin {
    Vec2d at;
    double depth_mm = 0;
};

/// A side that gets holes, on which it meets another piece.
struct PinnedSide {
    const MillField& field;
    bool turned = false;     ///< near and far lie the other way round than in the lower foam
    bool other_too = false;  ///< the piece gets holes from its other side as well
};

/// Where the sides get their pins.
struct MillPins {
    std::vector<std::vector<MillPin>> sides;  ///< the same places of the design
    bool no_room = false;
};

/// Two holes where all sides stand full height around them, near opposite corners, so placed that a piece
/// which is turned or mirrored does not fit on them. The first side is the lower foam's.
[[nodiscard]] MillPins mill_pins(std::span<const PinnedSide> sides, double pin_mm, double flute_mm);

}  // namespace snug
