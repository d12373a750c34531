#include "snug/design/carrier.h"

#include "snug/design/presets.h"

namespace snug {

void expect_drops(Carrier carrier, Design& design) {
    constexpr double kCarriedHeight = 760;  // mm
    if (design.protection.drops() || design.space.open || carrier == Carrier::store) return;
    if (carrier == Carrier::hand)
        design.protection.height_mm = kCarriedHeight;
    else
        design.protection.rule = DropRule::ista_2a;
}

double usual_wall_mm(Carrier carrier) {
    return carrier == Carrier::store ? 25 : 50;
}

double usual_wall_mm(const Design& design, Carrier carrier) {
    const auto& known = built_in_presets();
    auto preset = find_preset(known, design.space.preset);
    if (!preset) preset = find_preset(known, usual_preset(design.workshop.work));
    return (preset ? preset->wall_mm : std::nullopt).value_or(usual_wall_mm(carrier));
}

}  // namespace snug
