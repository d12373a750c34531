#include "snug/fabricate/kit/zone_text.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

Message kept_off(const ZoneReport& zone) {
    std::vector<Message> left;
    if (const auto side = zone.nearest())
        left.push_back(say("zone.left", {{"mm", number(std::max(0.0, *zone.left_mm[*side]), 0)},
                                         {"fallen", fallen_on(*side)}}));
    std::vector<Message> unknown;
    for (const Side side : zone.unknown) unknown.push_back(fallen_on(side));
    if (!unknown.empty()) left.push_back(say("zone.left_unknown", {{"fallen", std::move(unknown)}}));
    return say("zone.kept_off",
               {{"mm", number(zone.asked.keep_off_mm, 1)}, {"blocks", zone.cut_blocks}, {"left", left}});
}

Message pressed(const ZoneReport& zone) {
    const auto most = zone.most_kpa();
    if (!most) return say("zone.press_unknown", {{"asked", number(*zone.asked.press_kpa, 1)}});
    return say("zone.pressed", {{"kpa", number(*most, 1)}, {"asked", number(*zone.asked.press_kpa, 1)}});
}

}  // namespace

Message zone_text(const ZoneReport& zone) {
    std::vector<Message> parts;
    if (zone.asked.keep_off_mm > 0) parts.push_back(kept_off(zone));
    if (zone.asked.press_kpa) parts.push_back(pressed(zone));
    if (zone.asked.loose) parts.push_back(say("zone.loose"));
    return say("zone.told", {{"parts", std::move(parts)}});
}

}  // namespace snug
