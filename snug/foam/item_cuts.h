#pragma once

#include <memory>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/depth/item_depths.h"
#include "snug/foam/object_cut.h"
#include "snug/foam/zone_cuts.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// What items see of their columns, and what they cut with their zones.
struct ItemCuts {
    std::vector<std::shared_ptr<const ObjectDepths>> depths;
    std::vector<HalfCuts> cuts;
    std::vector<ZoneCut> zones;
    double depth_ms = 0, cut_ms = 0;  ///< that both took
};

/// Of every item where it lies. `kept`: as for item_depths(). Fails as item_depths() and cut_zones() do.
[[nodiscard]] Result<ItemCuts> cut_items(std::span<const Object> objects, const std::vector<Item>& items,
                                         const DesignSpace& space, KeptDepths* kept = nullptr,
                                         const Progress& progress = {});

/// The same with every item lowered until it lies on its foam (settle.h), `fixed` ones aside: moves them.
[[nodiscard]] Result<ItemCuts> cut_settled(std::span<const Object> objects, std::vector<Item>& items,
                                           const std::vector<bool>& fixed, const DesignSpace& space,
                                           KeptDepths* kept = nullptr, const Progress& progress = {});

}  // namespace snug
