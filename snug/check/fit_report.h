#pragma once

#include <array>
#include <span>
#include <vector>

#include "snug/base/side.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"

namespace snug {

/// Of one piece of the foams.
struct PieceFigures {
    long long blocks = 0;
    int parts = 0;  ///< of foam that do not share a block face
};

/// What can be read off the foams without looking at the object again.
struct FitReport {
    std::vector<PieceFigures> pieces{2};  ///< the lowest first; a tray's lid, which there is not, has none
    bool open = false;                    ///< a tray
    long long cut_blocks = 0;
    long long shortened_blocks = 0;  ///< that do not exist because the case is rounded or leans
    long long outside_blocks = 0;    ///< of those, what the object would need
    double foam_mm3 = 0;
    double fill_ratio = 0;  ///< F: foam volume / volume of all blocks that exist (the paper, section 3.4), of
                            ///< a tray below its surface
    std::array<double, 6> wall_mm{};  ///< thinnest foam between the cut and each side, whole blocks; above
                                      ///< a tray 0

    [[nodiscard]] const PieceFigures& lower() const { return pieces.front(); }
    [[nodiscard]] const PieceFigures& upper() const { return pieces.back(); }
    [[nodiscard]] long long foam_blocks() const;
};

/// `layers`: what each layer cuts. In a rounded or leaning case walls end where its blocks do.
[[nodiscard]] FitReport fit_report(const Foams& foams, std::span<const BlockMap> layers,
                                   const DesignSpace& space, const Grid<Run>& available);

}  // namespace snug
