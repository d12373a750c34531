#include "snug/foam/zone_cuts.h"

#include <array>
#include <utility>

namespace snug {
namespace {

long long blocks_of(const BlockMap& cut) {
    long long blocks = 0;
    for (const CutRun run : cut)
        if (!run.none()) blocks += run.end - run.first;
    return blocks;
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
            const auto depths = object_depths(*zone.surface, item.placement, space, zone.own_cut(item.cut));
            if (!depths) return tl::unexpected(depths.error());
            for (std::size_t column = 0; column < seen.size(); ++column)
                if (!depths->lower.depths[column].none()) seen[column] = 1;
        }
    return seen;
}

}  // namespace snug
