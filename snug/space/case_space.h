#pragma once

#include <optional>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/grid.h"
#include "snug/base/result.h"
#include "snug/base/run.h"
#include "snug/base/side.h"
#include "snug/design/case_options.h"
#include "snug/space/design_space.h"

namespace snug {

/// A case, divided into blocks. What a fixed pitch leaves lies as one sheet under the lower foam (or over the
/// lid's, where its blocks then come nearer to the lid's line), as strips at the front and at the right: one
/// thick strip is cut more easily than two thin ones.
struct CaseSpace {
    CaseOptions options;
    DesignSpace space;
    Box3d free;                    ///< the case's inside without the play, in design coordinates
    Vec3d rest_mm;                 ///< what the blocks leave on each axis; 0 where they fill it
    bool rest_under = true;        ///< the rest along x lies at the floor, not at the roof
    std::optional<int> lid_level;  ///< lower blocks up to the block boundary nearest to the lid's line
    double lid_off_mm = 0;         ///< that boundary above (positive) or below the lid's line
};

/// Divides the case into blocks of about this size. `options` must have its inside. Fails (does_not_fit,
/// usage) where not one block goes in, or more than 4096 on an axis.
[[nodiscard]] Result<CaseSpace> case_space(const CaseOptions& options, Vec3d block_mm);

/// The same with what the blocks leave along x above them: a tray stands on the floor.
[[nodiscard]] CaseSpace standing_on_floor(CaseSpace fitted);

/// Strips or sheets of foam that fill what the blocks leave.
struct Filler {
    Side side = kFloor;  ///< where it lies: at the floor or roof, front or right
    bool lid = false;    ///< belongs to the lid
    Vec3d size_mm;       ///< along x, y, z
};

/// All fillers for foams that part at this level. Together with the blocks they fill the case without its
/// play, and each belongs to one half. Where the case is rounded or leans, they are trimmed to it. `open`: of
/// a tray, without those of the lid.
[[nodiscard]] std::vector<Filler> fillers(const CaseSpace& fitted, int parting_level, bool open = false);

/// Whether rounded corners or leaning walls may keep blocks out of the case.
[[nodiscard]] bool has_shape(const CaseOptions& options);

/// The blocks that lie wholly inside the case, for each column.
[[nodiscard]] Grid<Run> available_blocks(const CaseSpace& fitted);

/// Whether a block from `low` to `high` (design coordinates) lies inside the case and its play.
[[nodiscard]] bool lies_inside(const CaseSpace& fitted, Vec3d low, Vec3d high);

}  // namespace snug
