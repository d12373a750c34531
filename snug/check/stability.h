#pragma once

#include <optional>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/vec.h"
#include "snug/foam/block_map.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// Where an item's weight acts, in design coordinates: the centre of its solid, taken to be of one density,
/// or of its box where it is not closed.
[[nodiscard]] Vec3d centre_of_mass(const Object& object, const Placement& placement);

/// How far a tray may be tilted, in the worst direction, until an item rolls out over the rim of its pocket:
/// its weight then acts outside the rim. Degrees; none where the weight lies below the surface, so that the
/// walls hold it at any tilt up to 90. `cut`: what the item cuts; the rim is the hull of what that is right
/// below the surface, the level `level`.
[[nodiscard]] std::optional<double> tip_angle_deg(const BlockMap& cut, const DesignSpace& space, int level,
                                                  Vec3d centre);

/// An item of a tray that has no pocket at all: `no_pocket` (danger); that tips out below 20 degrees:
/// `tips_out`; that is sunk less than `wanted_mm`, since foam or case is too low or the level was chosen:
/// `sunk_less` (warnings). `cut`, `level`: as for tip_angle_deg().
void find_tray_problems(const Item& item, double wanted_mm, const BlockMap& cut, int level,
                        const DesignSpace& space, std::vector<Finding>& findings);

}  // namespace snug
