#pragma once

#include <array>
#include <vector>

#include "snug/fabricate/mill/mill_field.h"

namespace snug {

/// A blind hole from the cavity's side, x and y as the half is milled.
struct MillPin {
    Vec2d at;
    double depth_mm = 0;
};

/// Where the halves get their pins.
struct MillPins {
    std::array<std::vector<MillPin>, 2> halves;  ///< lower, lid: the same places of the design
    bool no_room = false;
};

/// Two holes where both halves stand full height around them, near opposite corners, so placed that a half
/// which is turned or mirrored does not fit on them.
[[nodiscard]] MillPins mill_pins(const MillField& lower, const MillField& lid, double pin_mm,
                                 double flute_mm);

}  // namespace snug
