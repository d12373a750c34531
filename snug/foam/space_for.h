#pragma once

#include "snug/base/box.h"
#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/space/design_space.h"

namespace snug {

/// How far an object lies from the middle of a space that is fitted to it, where the walls on opposite sides
/// differ; nothing where the design chooses the blocks or a case. mm.
[[nodiscard]] Vec3d shift_between_walls(const SpaceOptions& space, bool in_case);

/// The design space outside of a case, fitted to the placed object where the design leaves the counts open:
/// with its clearance, its walls and room for its notches. `placed`: mm, design coordinates,
/// shift_between_walls() included. Fails (usage) beyond 4096 blocks on an axis.
[[nodiscard]] Result<DesignSpace> space_for(Box3d placed, const Design& design);

}  // namespace snug
