#pragma once

#include <optional>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/message.h"
#include "snug/design/design.h"
#include "snug/space/case_space.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// A tray: foam without a lid, whose items stand open at the top. Its surface is level, so the items are laid
// so deep that each is sunk into it by its share.

namespace snug {

/// How deep an item is sunk at least, `open` as in SpaceOptions. mm, never more than its height.
[[nodiscard]] double sunk_mm(double open, const Box3d& placed);

/// How deep an item lies in a tray whose foam ends at this level, had it no offset along x of its own. mm.
[[nodiscard]] double reached_mm(const Item& item, int level, const DesignSpace& space);

/// The level where a tray's foam ends: the lowest at which all items of its uppermost layer are sunk as deep
/// as they must be, 1 to nx.
[[nodiscard]] int tray_level(double open, const std::vector<Item>& uppermost, const DesignSpace& space);

/// Lays the items along x: those of the uppermost layer so that one surface, at x = 0, sinks all of them as
/// deep as they must be, and each layer below `apart_mm` under the one above it. The x of an item's offset is
/// counted from there.
void settle_in_tray(std::vector<Item>& items, double open, double apart_mm);

/// How far settled items must rise so that below the lowest, as if none had an offset along x, lies so much
/// foam in whole blocks. `floor_x`: where the foam begins. mm.
[[nodiscard]] double rise_to_floor(const std::vector<Item>& items, double floor_x, double floor_mm,
                                   double block_mm);

/// Why an item of a tray does not go into its case; none where its top stays inside.
[[nodiscard]] std::optional<Message> too_high_for_case(const Item& item, const CaseSpace& fitted,
                                                       const DesignSpace& space);

}  // namespace snug
