#include "snug/foam/zone_cuts.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace snug {
namespace {

long long blocks_of(const BlockMap& cut) {
    long long blocks = 0;
    for (const CutRun run : cut)
        if (!run.none()) blocks += run.end - run.first;
    return blocks;
}

bool sees_nothing(const ObjectDepths& depths) {
    const DepthMap& map = depths.lower.depths;
    return std::all_of(map.begin(), map.end(), [](const DepthRange& depth) { return depth.none(); });
}

}  // namespace

Result<std::vector<ZoneCut>> cut_zones(const Item& item, std::size_t number, const DesignSpace& space,
                                       HalfCuts& cuts, const Progress& progress) {
    std::vector<ZoneCut> all;
    for (std::size_t i = 0; i < item.zones.size(); ++i) {
        const ItemZone& zone = item.zones[i];
        if (zone.asked.keep_off_mm <= 0) continue;
        auto depths = object_depths(*zone.surface, item.placement, space, zone.own_cut(item.cut), progress);
        if (!depths) return tl::unexpected(depths.error());
        if (zone.surface->is_streamed() && sees_nothing(*depths))
            return fail(ErrorKind::usage, say("zone.numbered", {{"zone", std::to_string(i + 1)},
                                                                {"why", say("zone.none_of_stream")}}));
        const HalfCuts own = half_cuts(*depths, space);
        const long long before = blocks_of(cut_by_either(cuts));
        cuts = united(std::array<const HalfCuts*, 2>{&cuts, &own});
        all.push_back({number, i, blocks_of(cut_by_either(cuts)) - before});
    }
    return all;
}

Result<Grid<char>> zone_columns(const std::vector<Item>& items, const DesignSpace& space) {
    Grid<char> seen(space.blocks.y, space.blocks.z, 0);
    for (const Item& item : items)
        for (const ItemZone& zone : item.zones) {
            CutOptions cut = item.cut;
            cut.clearance_mm = std::max(zone.asked.keep_off_mm, 0.0);
            cut.liner_mm = 0;
            const auto depths = object_depths(*zone.surface, item.placement, space, cut);
            if (!depths) return tl::unexpected(depths.error());
            for (std::size_t column = 0; column < seen.size(); ++column)
                if (!depths->lower.depths[column].none()) seen[column] = 1;
        }
    return seen;
}

}  // namespace snug
