#pragma once

#include <optional>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/check/fit_report.h"
#include "snug/check/protection_report.h"
#include "snug/foam/block_map.h"
#include "snug/foam/fill_pads.h"
#include "snug/foam/foams.h"
#include "snug/foam/hand_edits.h"
#include "snug/foam/lift_slots.h"
#include "snug/foam/notches.h"
#include "snug/foam/relief_islands.h"
#include "snug/foam/zone_cuts.h"
#include "snug/space/case_space.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// Milliseconds that each stage of the method took; never part of a comparison.
struct Timing {
    double read = 0, depth_map = 0, block_map = 0, foam_pair = 0, solids = 0, write = 0;
};

/// Objects in their foams, and what is true of them.
struct Packing {
    std::vector<Item> items;  ///< as the design has them, one at least
    DesignSpace space;
    std::optional<CaseSpace> fitted_case;  ///< where the design has a case: what `space` is of
    Grid<Run> available;                   ///< blocks that exist in `space`
    std::vector<BlockMap> layers;          ///< what each layer of items cuts, the lowest first
    std::vector<BlockMap> pockets;         ///< what each of several items cuts, where drops are looked at
    std::vector<ZoneCut> zone_cuts;        ///< of the zones that foam keeps away from
    std::vector<Notch> notches;         ///< beside the items, where the design wants them and there is room
    std::optional<FloorRelief> relief;  ///< under an only item, where the design wants it
    FillPads pads;                      ///< that fill what block steps leave, where the design wants them
    LiftSlots lift;                     ///< in the pieces that are lifted, where the design wants them
    std::vector<EditOutcome> edits;     ///< what came of the design's edits, in their order
    long long rib_blocks = 0;           ///< cut because they stood too thin between cavities
    std::optional<Foams> foams;         ///< none where an item leaves the space (finding `outside`)
    FitReport fit;                      ///< of `foams`
    std::optional<Protection> protection;  ///< what is met in a drop; none where the design does not ask
    std::vector<Finding> findings;         ///< dangers first
    Timing timing;
};

}  // namespace snug
