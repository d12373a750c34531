#pragma once

#include <vector>

#include "snug/base/result.h"
#include "snug/object/object.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/item.h"

namespace snug {

/// An object's zones that foam keeps away from, ready for many placements and placed nowhere yet: of a mesh
/// those that pack() cuts, of another kind those of its stand-in, which it must have. Their balls are left
/// out. Fails as zone_surface() does; the sentence tells which zone.
[[nodiscard]] Result<std::vector<ItemZone>> searched_zones(const Object& object, const Zones& zones);
/// Of the design's only item.
[[nodiscard]] Result<std::vector<ItemZone>> searched_zones(const Object& object, const Design& design);

/// An object alone, so placed with its zones. mm; degrees.
[[nodiscard]] Item lying(const PreparedSurface& surface, const CutOptions& cut,
                         const std::vector<ItemZone>& zones, Vec3d rotation_deg, Vec3d offset_mm);
/// The same where it is known where the object lies.
[[nodiscard]] Item lying(const Placement& placement, const CutOptions& cut,
                         const std::vector<ItemZone>& zones);

}  // namespace snug
