#include "snug/depth/item_depths.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace snug {
namespace {

bool same(const Placement& a, const Placement& b) {
    return a.rotation.row == b.rotation.row && a.shift == b.shift;
}

bool same(const DesignSpace& a, const DesignSpace& b) {
    return a.blocks == b.blocks && a.block_mm == b.block_mm;
}

std::shared_ptr<const ObjectDepths> found(const KeptDepths& kept, std::uint64_t edition, const Item& item) {
    const auto entry =
        std::find_if(kept.entries.begin(), kept.entries.end(), [&](const KeptDepths::Entry& each) {
            return edition != 0 && each.edition == edition && same(each.placement, item.placement) &&
                   each.cut == item.cut;
        });
    return entry == kept.entries.end() ? nullptr : entry->depths;
}

}  // namespace

Result<std::vector<std::shared_ptr<const ObjectDepths>>> item_depths(std::span<const Object> objects,
                                                                     const std::vector<Item>& items,
                                                                     const DesignSpace& space,
                                                                     KeptDepths* kept,
                                                                     const Progress& progress) {
    KeptDepths last;
    const auto lowered = kept ? kept->lowered : nullptr;
    if (kept) std::swap(last, *kept);
    if (!same(last.space, space)) last.entries.clear();

    std::vector<std::shared_ptr<const ObjectDepths>> all;
    std::vector<KeptDepths::Entry> entries;
    const double share = 1 / static_cast<double>(items.size());
    for (const Item& item : items) {
        const Object& object = objects[item.object];
        auto one = found(last, object.edition, item);
        if (!one) {
            const double done = share * static_cast<double>(all.size());
            auto depths =
                object_depths(object, item.placement, space, item.cut, part_of(progress, done, done + share));
            if (!depths) return tl::unexpected(depths.error());
            one = std::make_shared<const ObjectDepths>(std::move(*depths));
        }
        if (kept && object.edition != 0) entries.push_back({object.edition, item.placement, item.cut, one});
        all.push_back(std::move(one));
    }
    if (kept) *kept = {space, std::move(entries), lowered};
    return all;
}

}  // namespace snug
