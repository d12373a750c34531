#include "snug/check/relieved.h"

#include <string_view>
#include <utility>

#include "snug/check/protection.h"

namespace snug {

std::optional<Message> never_relieved(const Design& design) {
    if (design.items.size() > 1) return say("no_relief/items");
    const Workshop work = design.workshop.work;
    const bool plank = work == Workshop::none || work == Workshop::sheets || work == Workshop::mill;
    const std::string_view preset = design.space.preset;
    const bool loose = preset == "paper" || preset.starts_with("slit-") || preset.starts_with("cube-");
    if (!plank || loose) return say("no_relief/foam");
    return {};
}

Result<RelievedItem> relieved_item(const Object& object, const Packing& packing, const Design& design,
                                   const BlockMap& own) {
    auto zones = zone_columns(packing.items, packing.space);
    if (!zones) return tl::unexpected(zones.error());
    Grid<int> under(own.ny(), own.nz(), 0);
    for (std::size_t column = 0; column < under.size(); ++column)
        under[column] = packing.available[column].first;
    const Vec3d centre = mass_centre(object, packing.items.front(), design.items.front(), design);
    return RelievedItem{
        own, std::move(*zones), std::move(under), {centre.y, centre.z}, design.fit.least_rib_mm};
}

Result<void> relieve(const Object& object, Packing& packing, const Design& design, const BlockMap& own,
                     BlockMap& layer) {
    FloorRelief relief;
    if (const auto why = never_relieved(design)) {
        relief.why_not = *why;
    } else {
        const auto item = relieved_item(object, packing, design, own);
        if (!item) return tl::unexpected(item.error());
        relief = relief_islands(layer, *item, packing.space, *design.fit.relief);
        if (!relief.islands.empty()) cut_relief(layer, *item, relief);
    }
    if (relief.islands.empty())
        packing.findings.push_back({Severity::warning, relief.why_not, {}, {}});
    else
        packing.relief = std::move(relief);
    return {};
}

}  // namespace snug
