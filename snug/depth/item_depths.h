#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/depth/object_depths.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// What each item of a packing saw of its columns, for the next packing: where one of many items moves, the
/// others are not computed again. Items of an object without an edition (object.h) are not kept.
struct KeptDepths {
    struct Entry {
        std::uint64_t edition = 0;
        Placement placement;
        CutOptions cut;
        std::shared_ptr<const ObjectDepths> depths;
    };
    DesignSpace space;
    std::vector<Entry> entries;
    std::shared_ptr<KeptDepths> lowered;  ///< of the same items once they are settled, see settle.h
};

/// The depth maps of every item, those taken from `kept` that depend on nothing else than then; afterwards
/// `kept` holds these. Fails as object_depths() does; then `kept` is empty.
[[nodiscard]] Result<std::vector<std::shared_ptr<const ObjectDepths>>> item_depths(
    std::span<const Object> objects, const std::vector<Item>& items, const DesignSpace& space,
    KeptDepths* kept = nullptr, const Progress& progress = {});

}  // namespace snug
