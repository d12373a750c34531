#include "snug/foam/item_cuts.h"

#include <algorithm>
#include <cstddef>

#include "snug/base/stopwatch.h"
#include "snug/foam/settle.h"

namespace snug {

Result<ItemCuts> cut_items(std::span<const Object> objects, const std::vector<Item>& items,
                           const DesignSpace& space, KeptDepths* kept, const Progress& progress) {
    Stopwatch watch;
    auto depths = item_depths(objects, items, space, kept, progress);
    if (!depths) return tl::unexpected(depths.error());
    ItemCuts all{std::move(*depths), {}, {}};
    all.depth_ms = watch.lap();
    for (std::size_t i = 0; i < items.size(); ++i) {
        all.cuts.push_back(half_cuts(*all.depths[i], space));
        const auto zones = cut_zones(items[i], i, space, all.cuts.back());
        if (!zones) return tl::unexpected(zones.error());
        all.zones.insert(all.zones.end(), zones->begin(), zones->end());
    }
    all.cut_ms = watch.lap();
    return all;
}

Result<ItemCuts> cut_settled(std::span<const Object> objects, std::vector<Item>& items,
                             const std::vector<bool>& fixed, const DesignSpace& space, KeptDepths* kept,
                             const Progress& progress) {
    // What a zone cuts goes down with it and may take away what the item lay on: then it goes down further.
    constexpr int kMostTimes = 4;
    double depth_ms = 0, cut_ms = 0;
    auto all = cut_items(objects, items, space, kept, part_of(progress, 0, 0.5));
    for (int time = 0; all && time < kMostTimes; ++time) {
        const std::vector<double> mm = free_below_mm(items, all->depths, all->cuts, space, fixed);
        if (std::all_of(mm.begin(), mm.end(), [](double each) { return each == 0; })) break;
        for (std::size_t i = 0; i < mm.size(); ++i) settle(items[i], mm[i]);
        depth_ms += all->depth_ms;
        cut_ms += all->cut_ms;
        if (kept && !kept->lowered) kept->lowered = std::make_shared<KeptDepths>();
        all =
            cut_items(objects, items, space, kept ? kept->lowered.get() : nullptr, part_of(progress, 0.5, 1));
    }
    if (all) {
        all->depth_ms += depth_ms;
        all->cut_ms += cut_ms;
    }
    return all;
}

}  // namespace snug
