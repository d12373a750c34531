#pragma once

#include "snug/base/box.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/design/fit_options.h"
#include "snug/design/walls.h"

namespace snug {

/// The fewest blocks of a size that hold an object with its clearance and at least the walls in whole foam
/// blocks on each side: an axis counts ceil((length - 0.02) / size) + ceil(wall / size) for each of its
/// walls. `grown` is the room that the object takes with its clearance, in design coordinates; away from the
/// centre the space grows on both sides. Counts may pass the limit of 4096.
[[nodiscard]] Vec3d fitted_blocks(const Box3d& grown, Vec3d block_mm, const Walls& walls = {});

/// The whole blocks that a length takes.
[[nodiscard]] int whole_blocks(double mm, double block_mm);

/// The object's box with room for notches on both sides of its narrower way, for a space that is fitted to
/// it.
[[nodiscard]] Box3d with_room_for_notches(Box3d grown, Vec3d block_mm, const NotchOptions& options);

/// How far the object moves from the centre of such a space where the walls on opposite sides differ, in mm:
/// whole or half blocks, so that it meets the blocks as it would in the middle.
[[nodiscard]] Vec3d fitted_shift(Vec3d block_mm, const Walls& walls);

/// How far an object lies from the middle of a space that is fitted to it, where the walls on opposite sides
/// differ; nothing where the design chooses the blocks or a case. mm.
[[nodiscard]] Vec3d shift_between_walls(const SpaceOptions& space, bool in_case);

}  // namespace snug
