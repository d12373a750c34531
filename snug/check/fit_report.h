#pragma once

#include <array>

#include "snug/base/side.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"

namespace snug {

/// What can be read off the foams without looking at the object again.
struct FitReport {
    long long lower_blocks = 0;
    long long upper_blocks = 0;
    long long cut_blocks = 0;
    long long shortened_blocks = 0;  ///< that do not exist because the case is rounded or leans
    long long outside_blocks = 0;    ///< of those, what the object would need
    double foam_mm3 = 0;
    double fill_ratio = 0;  ///< F: foam volume / volume of all blocks that exist (the paper, section 3.4)
    std::array<double, 6> wall_mm{};  ///< thinnest foam between the cut and each side, whole blocks
    int lower_pieces = 0;             ///< pieces of foam that do not share a block face
    int upper_pieces = 0;
};

/// In a rounded or leaning case walls end where its blocks do.
[[nodiscard]] FitReport fit_report(const Foams& foams, const BlockMap& blocks, const DesignSpace& space,
                                   const Grid<Run>& available);

}  // namespace snug
