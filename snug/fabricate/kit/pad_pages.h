#pragma once

#include <string>
#include <vector>

#include "snug/drawing/page_builder.h"
#include "snug/foam/fill_pads.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"

namespace snug {

/// What pages tell of pads. References live as long as the packing.
struct PadPlans {
    const FillPads& pads;
    const Foams& foams;
    const DesignSpace& space;
    std::vector<std::string> item_names;  ///< of items that are to be told apart; empty where there is one
};

/// "LOWER, C3 to E7, 20 mm from the left and 40 mm from BACK: 40 x 30 x 6 mm (3 sheets of 2 mm)", as its
/// piece is seen into the cavity.
[[nodiscard]] Message pad_text(const FillPad& pad, const DesignSpace& space);

/// A heading, the pads of each side of each piece as it is seen into its cavity, and a list by their numbers,
/// counted from 1 in the order of `pads`. Nothing where there are none.
void tell_pads(PageFlow& flow, const PadPlans& plans);

}  // namespace snug
