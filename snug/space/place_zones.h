#pragma once

#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/space/item.h"

namespace snug {

/// What of an object's surface lies in each zone, and where it lies with the object. Fails as zone_surface()
/// does; the sentence tells which zone.
[[nodiscard]] Result<std::vector<ItemZone>> place_zones(const Object& object, const Zones& zones,
                                                        const Placement& placement,
                                                        const Progress& progress = {});
/// The same of zones that are known, of the object in another place; of a stream their bounds may then be too
/// large.
[[nodiscard]] std::vector<ItemZone> place_zones(std::vector<ItemZone> zones, const Placement& placement);
/// What a box in the object's coordinates reaches where it lies, within the object's own bounds.
[[nodiscard]] Box3d placed_box(const Box3d& own, const Placement& placement);

}  // namespace snug
