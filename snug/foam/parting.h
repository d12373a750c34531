#pragma once

#include "snug/base/box.h"
#include "snug/foam/block_map.h"
#include "snug/space/design_space.h"

namespace snug {

/// The sum over neighbouring columns of the change of both halves times the side's area, in mm2, for one
/// level.
[[nodiscard]] double stepped_wall_area(const BlockMap& blocks, const DesignSpace& space, int level);

/// The level where the halves meet in columns that the object does not touch. Within the object's cut range
/// the level with the least stepped wall area; among equals the nearest to the middle of the object's height
/// (`object`: its placed bounding box) where the lower foam still holds the object sideways, that is, rises
/// above the lowest cut block; among those the higher.
[[nodiscard]] int auto_parting_level(const BlockMap& blocks, const DesignSpace& space, const Box3d& object);

}  // namespace snug
