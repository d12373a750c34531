#include "snug/fabricate/kit/shock_text.h"

#include "snug/base/text.h"
#include "snug/check/drop_sentence.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

Message shock_of(const FaceShock& face) {
    if (!face.g_low || !face.g_high) return drop_range(face);
    return say("summary.drop_g", {{"range", drop_range(face)}, {"deep", drop_depth(face)}});
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
                                     {"status", status_text(all.foam->status)}});
}

std::vector<Message> face_texts(const Protection& all) {
    std::vector<Message> texts;
    for (int side = 0; side < 6; ++side) {
        const ItemProtection& worst = all.items[all.worst_item(static_cast<Side>(side))];
        texts.push_back(
            say("summary.drop_face", {{"fallen", fallen_on(static_cast<Side>(side))},
                                      {"what", shock_of(worst.faces[static_cast<std::size_t>(side)])}}));
    }
    return texts;
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
