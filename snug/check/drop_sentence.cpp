#include "snug/check/drop_sentence.h"

#include <string>

#include "snug/base/text.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

Message shock_text(const FaceShock& face, const ItemProtection& item, const std::string& cm) {
    const Message drop =
        say("drop.g", {{"cm", cm}, {"fallen", fallen_on(face.face)}, {"range", drop_range(face)}});
    if (!item.asked_g) return drop;
    const std::string asked = number(*item.asked_g, 0);
    if (verdict_on(face, item) == DropVerdict::over)
        return say("drop.over", {{"drop", drop}, {"asked", asked}});
    return say("drop.within", {{"drop", drop}, {"asked", asked}});
}

Message more_or_other_foam(const FaceShock& face, const FoamMaterial& foam) {
    if (face.more_foam_mm)
        return foam.dynamic() ? say("shock.more_foam", {{"mm", number(*face.more_foam_mm, 0)}})
                              : say("shock.more_foam_or_data", {{"mm", number(*face.more_foam_mm, 0)}});
    return foam.dynamic() ? say("shock.other_foam") : say("shock.other_foam_or_data");
}

}  // namespace

DropVerdict verdict_on(const FaceShock& face, const ItemProtection& item) {
    if (face.meets_item) return DropVerdict::meets_item;
    if (face.bottoms || face.why_none == NoShock::bottoms) return DropVerdict::bottoms;
    if (face.why_none == NoShock::thin) return DropVerdict::thin;
    if (!face.g_low || !face.g_high) return DropVerdict::unknown;
    if (!item.asked_g) return DropVerdict::unasked;
    return *face.g_high > *item.asked_g ? DropVerdict::over : DropVerdict::within;
}

bool is_enough(const FaceShock& face, const ItemProtection& item) {
    const DropVerdict verdict = verdict_on(face, item);
    return verdict == DropVerdict::within || verdict == DropVerdict::unasked;
}

Message drop_range(const FaceShock& face) {
    if (face.bottoms || face.why_none == NoShock::bottoms) return say("summary.drop_bottoms");
    if (!face.g_low || !face.g_high) return say("summary.drop_none");
    return say("drop.range", {{"low", number(*face.g_low, 0)}, {"high", number(*face.g_high, 0)}});
}

Message drop_depth(const FaceShock& face) {
    return say("drop.deep", {{"mm", number(*face.travel_mm, 0)}});
}

Message drop_sentence(const FaceShock& face, const ItemProtection& item, const Protection& all) {
    const DropVerdict verdict = verdict_on(face, item);
    if (verdict == DropVerdict::unknown)
        return no_shock_text(face.why_none).value_or(say("summary.drop_none"));
    const std::string cm = number(*all.drop_mm / 10, 0);
    const Message fallen = fallen_on(face.face);
    if (verdict == DropVerdict::meets_item) return say("drop.items_meet", {{"cm", cm}, {"fallen", fallen}});
    if (verdict == DropVerdict::bottoms) return say("drop.bottoms", {{"cm", cm}, {"fallen", fallen}});
    if (verdict == DropVerdict::thin)
        return say("drop.thin",
                   {{"cm", cm}, {"fallen", fallen}, {"mm", number(all.foam->least_thickness_mm(), 1)}});
    return shock_text(face, item, cm);
}

std::optional<Message> drop_advice(const FaceShock& face, const ItemProtection& item, const Protection& all) {
    switch (verdict_on(face, item)) {
        case DropVerdict::meets_item:
            return say("shock.more_between");
        case DropVerdict::thin:
            return say("shock.thicker_walls");
        case DropVerdict::bottoms:
        case DropVerdict::over:
            return more_or_other_foam(face, *all.foam);
        default:
            return {};
    }
}

std::optional<Message> no_contact_text(const ItemProtection& item, const Protection& all,
                                       std::optional<Side> side) {
    if (side) {
        const FaceShock& face = item.faces[static_cast<std::size_t>(*side)];
        if (face.why_none == NoShock::none) return {};
        return drop_sentence(face, item, all);
    }
    switch (item.rest.why_none) {
        case NoShock::none:
            return {};
        case NoShock::no_mass:
            return say("rest.unknown/mass");
        case NoShock::bottoms:
            return say("rest.unknown/bottoms");
        default:
            return say("rest.unknown/foam");
    }
}

std::optional<Message> no_shock_text(NoShock why) {
    switch (why) {
        case NoShock::no_foam_data:
            return say("no_shock/foam");
        case NoShock::no_mass:
            return say("no_shock/mass");
        case NoShock::no_height:
            return say("no_shock/height");
        case NoShock::open:
            return say("no_shock/open");
        case NoShock::unsettled:
            return say("no_shock/unsettled");
        default:
            return {};
    }
}

}  // namespace snug
