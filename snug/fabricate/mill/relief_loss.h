#pragma once

#include <span>

#include "snug/fabricate/mill/mill_relief.h"

namespace snug {

/// Foam that the blocks keep and reliefs take.
struct ReliefLoss {
    double mm3 = 0;  ///< what all reliefs together take, once where they overlap
    double widest_mm =
        0;  ///< never less than the farthest from where the blocks are cut as deep; 0: takes none
};

/// Measured along lines that lie a 64th of the radius apart, exactly along each.
[[nodiscard]] ReliefLoss relief_loss(const MillField& field, std::span<const MillRelief> reliefs,
                                     double radius_mm);

}  // namespace snug
