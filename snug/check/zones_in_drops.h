#pragma once

#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/face_shocks.h"
#include "snug/check/packing.h"
#include "snug/check/pad_contacts.h"
#include "snug/check/protection_report.h"

namespace snug {

/// The zones of all items and the room around them. Fails as zone_room_mm() does.
[[nodiscard]] Result<std::vector<ZoneReport>> zone_reports(const Packing& packing,
                                                           const Progress& progress = {});

/// What foam presses on zones with along the axis of the contacts, once the faces of that axis are known.
void add_zone_pressures(const AxisContacts& contacts, const Curves& curves, Protection& all);

/// What is left of the zones' room once all faces are known; and what a person must know: `zone_reached`
/// (danger), `zone_pressed`, `zone_free` (notes what is not computed of parts that stand free).
void find_zones(Protection& all, const Packing& packing, std::vector<Finding>& findings);

}  // namespace snug
