#pragma once

#include <optional>

#include "snug/base/box.h"
#include "snug/base/grid.h"
#include "snug/base/result.h"
#include "snug/base/run.h"
#include "snug/design/design.h"
#include "snug/space/case_space.h"
#include "snug/space/design_space.h"

namespace snug {

/// The blocks that an object is packed in.
struct PackedSpace {
    DesignSpace space;
    std::optional<CaseSpace> fitted_case;  ///< where the design has a case: what `space` is of
    Grid<Run> available;                   ///< blocks that exist in `space`
};

/// The design's case, divided into blocks; a tray stands on its floor. Fails as case_space(CaseOptions, ...)
/// does.
[[nodiscard]] Result<CaseSpace> case_space(const Design& design);

/// The space of a design: its case divided into blocks, its own counts, or fitted to what the placed items
/// take up, with walls and room for notches. `room`: of the items grown by their clearance, mm, design
/// coordinates, shift_between_walls() included; `least_clearance`: of all of them, mm. Fails with kind
/// `does_not_fit` where not one block goes into the case, and with kind `usage` beyond 4096 blocks on an axis
/// or where the case's blocks are too small to be squeezed so much.
[[nodiscard]] Result<PackedSpace> space_for(const Box3d& room, double least_clearance, const Design& design);
/// For one object, grown by the design's clearance.
[[nodiscard]] Result<PackedSpace> space_for(const Box3d& placed, const Design& design);

}  // namespace snug
