#pragma once

#include "snug/fabricate/bricks/brick_build.h"
#include "snug/fabricate/bricks/brick_statics.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/space/design_space.h"

namespace snug {

/// What the statics of one half come to, for people: a figure for each load case, a warning for each in
/// which the half does not hold, with the place and what to do about it, and a note where it was not
/// checked. Codes: bricks_overloaded, bricks_loose, bricks_fall, bricks_unchecked.
void tell_statics(const BrickBuild& build, const DesignSpace& space, const BrickStatics& statics,
                  WorkshopPack& pack);

/// The place in design coordinates of a point of the half: rows and columns of studs, plates from its floor.
[[nodiscard]] Vec3d design_place(const BrickBuild& build, const DesignSpace& space, double row, double column,
                                 double plates);

}  // namespace snug
