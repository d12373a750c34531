#pragma once

#include <array>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/space/item.h"

namespace snug {

/// How much room a zone needs all round to count as free, mm.
constexpr double kZoneRoom = 3;

/// How far a zone's surface can go towards each side (by Side) until foam or the end of the blocks' room is
/// met by it or by what lies within kZoneRoom beside the way, mm; infinite above a tray. Exact, from depth
/// maps along each axis. Of a stream by three passes over its file; fails only where those do.
[[nodiscard]] Result<std::array<double, 6>> zone_room_mm(const ItemZone& zone, const Item& item,
                                                         const Packing& packing,
                                                         const Progress& progress = {});

}  // namespace snug
