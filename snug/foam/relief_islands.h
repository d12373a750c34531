#pragma once

#include <cstddef>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/message.h"
#include "snug/base/vec2.h"
#include "snug/design/fit_options.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// A part of the foam below an item that goes on carrying it, in whole columns.
struct ReliefIsland {
    int first_j = 0, end_j = 0, first_k = 0, end_k = 0;
    [[nodiscard]] bool has(int j, int k) const {
        return j >= first_j && j < end_j && k >= first_k && k < end_k;
    }
};

/// What of its layer an item cuts, and where foam may carry it.
struct RelievedItem {
    BlockMap own;       ///< the lower half's cut, with its zones
    Grid<char> zones;   ///< columns in which one of its zones is seen: none of them carries it
    Grid<int> under;    ///< the block at which the foam below it begins
    Vec2d centre;       ///< of its mass, y and z, mm
    double rib_mm = 0;  ///< no island is narrower
};

/// The islands of an item, or why there are none (`no_relief`).
struct FloorRelief {
    std::vector<ReliefIsland> islands;  ///< three or four
    int blocks = 0;                     ///< that they stand free
    double foam_mm = 0;                 ///< that lies below the lowest of them, free part included
    long long cut_blocks = 0;           ///< for their sake
    Message why_not;
};

/// An island buckles where it is small for its height: its area must be (1.33 r)^2 at least (Kerstner, in
/// MIL-HDBK-304).
constexpr double kBucklingShare = 1.33;
/// Foam under an island spreads its load, so that the free part must be most of it for the sum of columns to
/// hold.
constexpr double kLeastReliefShare = 0.7;
/// So much of the item's pocket lies between an island and the rim at least, so that it stands free, mm.
constexpr double kBesideIsland = 5;
/// Columns carry an item that end so close above the lowest of them, mm.
constexpr double kCarryingDepth = 10;

/// Where the islands of an item stand: as far from the centre of its mass as foam carries it, one towards
/// each corner, three at least that are not in line and have the centre between them. Chooses and cuts
/// nothing.
[[nodiscard]] FloorRelief relief_islands(const BlockMap& layer, const RelievedItem& item,
                                         const DesignSpace& space, const ReliefOptions& options);

/// Takes the foam away from under the item but for its islands: into `layer`, what is cut of all items of its
/// layer. Columns beside its own pocket stay, so the rim does. Counts into relief.cut_blocks.
void cut_relief(BlockMap& layer, const RelievedItem& item, FloorRelief& relief);

}  // namespace snug
