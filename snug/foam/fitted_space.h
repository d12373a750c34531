#pragma once

#include "snug/base/box.h"
#include "snug/base/vec.h"

namespace snug {

/// The fewest blocks of a size that hold an object with a clearance and at least wall_mm of whole foam blocks
/// on each side: an axis counts ceil((length + 2 clearance - 0.02) / size) + 2 ceil(wall / size). `placed` is
/// the object's box in design coordinates; away from the centre the space grows on both sides. Counts may
/// pass the limit of 4096.
[[nodiscard]] Vec3d fitted_blocks(const Box3d& placed, Vec3d block_mm, double clearance_mm, double wall_mm);

}  // namespace snug
