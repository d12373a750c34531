#include "snug/fabricate/kit/shock_text.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "snug/base/text.h"
#include "snug/check/drop_sentence.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

Message shock_of(const FaceShock& face) {
    if (!face.g_low || !face.g_high) return drop_range(face);
    return say("summary.drop_g", {{"range", drop_range(face)}, {"deep", drop_depth(face)}});
}

/// Whether every item bears the same.
bool one_for_all(const std::vector<ItemProtection>& items) {
    return std::all_of(items.begin(), items.end(),
                       [&](const ItemProtection& item) { return item.asked_g == items.front().asked_g; });
}

}  // namespace

Message drop_text(const Protection& all) {
    std::vector<Message> rule;
    if (all.rule)
        rule.push_back(say(is_verified(*all.rule) ? "summary.drop_rule" : "summary.drop_rule/unverified",
                           {{"rule", title_of(*all.rule)}}));
    return say("summary.drop_from", {{"height", number(*all.drop_mm, 0)},
                                     {"rule", rule},
                                     {"foam", all.foam->name},
                                     {"status", status_text(all.foam->status)},
                                     {"curve", curve_text(*all.foam)}});
}

std::vector<Message> face_texts(const Protection& all) {
    std::vector<Message> texts;
    for (int side = 0; side < 6; ++side) {
        const ItemProtection& worst = all.items[all.worst_item(static_cast<Side>(side))];
        const Message fallen = fallen_on(static_cast<Side>(side));
        const Message what = shock_of(worst.faces[static_cast<std::size_t>(side)]);
        texts.push_back(worst.name.empty() ? say("summary.drop_face", {{"fallen", fallen}, {"what", what}})
                                           : say("summary.drop_face/item",
                                                 {{"fallen", fallen}, {"what", what}, {"item", worst.name}}));
    }
    return texts;
}

std::optional<Message> borne_text(const Protection& all) {
    std::vector<Message> borne;
    for (const ItemProtection& item : all.items) {
        if (!item.asked_g) continue;
        const std::string g = number(*item.asked_g, 0);
        if (one_for_all(all.items)) return say("summary.borne_by_all", {{"g", g}});
        borne.push_back(say("summary.borne_by", {{"item", item.name}, {"g", g}}));
    }
    if (borne.empty()) return {};
    return say("summary.borne", {{"items", borne}});
}

std::vector<Message> not_computed() {
    return {say("not_computed.rim"),       say("not_computed.air"),     say("not_computed.case"),
            say("not_computed.rebound"),   say("not_computed.corners"), say("not_computed.cold"),
            say("not_computed.resonance"), say("not_computed.ageing")};
}

Message curve_text(const FoamMaterial& foam) {
    if (foam.curve.empty()) return as_it_is("-");
    return say(foam.dynamic() ? "list.curve_of_drops" : "list.curve_of_pressing",
               {{"percent", number(foam.curve.back().strain * 100, 0)}});
}

Message status_text(FoamStatus status) {
    constexpr const char* kCodes[] = {"foam_status.measured", "foam_status.sheet", "foam_status.model",
                                      "foam_status.unverified"};
    return say(kCodes[static_cast<std::size_t>(status)]);
}

}  // namespace snug
