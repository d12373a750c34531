#include "snug/check/find_shocks.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/words/sides.h"

namespace snug {
namespace {

/// What would do, as a part of a sentence.
Message advice(const FaceShock& face, const FoamMaterial& foam) {
    if (face.more_foam_mm)
        return foam.dynamic() ? say("shock.more_foam", {{"mm", number(*face.more_foam_mm, 0)}})
                              : say("shock.more_foam_or_data", {{"mm", number(*face.more_foam_mm, 0)}});
    return foam.dynamic() ? say("shock.other_foam") : say("shock.other_foam_or_data");
}

/// What is wrong with a drop of an item on a side.
enum class Wrong { nothing, meets_item, bottoms, thin, too_much };

Wrong wrong_with(const FaceShock& face, const ItemProtection& item) {
    if (face.meets_item) return Wrong::meets_item;
    if (face.bottoms)
        return face.bottoms_itself ? Wrong::bottoms : Wrong::nothing;  // said of what it reaches
    if (face.why_none == NoShock::thin) return Wrong::thin;
    const bool judged = face.g_high && item.asked_g;
    return judged && *face.g_high > *item.asked_g ? Wrong::too_much : Wrong::nothing;
}

Severity severity_of(Wrong wrong) {
    return wrong == Wrong::meets_item || wrong == Wrong::bottoms ? Severity::danger : Severity::warning;
}

/// `others`: of how many items more the same is true.
Message sentence(Wrong wrong, const FaceShock& face, const ItemProtection& item, const Protection& all,
                 std::size_t others) {
    const std::string cm = number(*all.drop_mm / 10, 0);
    const Message fallen = fallen_on(face.face);
    std::vector<Message> more;
    if (others > 0) more.push_back(say("shock.others", {{"items", others}}));
    if (wrong == Wrong::meets_item)
        return say("items_meet", {{"cm", cm}, {"fallen", fallen}, {"more", more}});
    if (wrong == Wrong::bottoms)
        return say("bottoms",
                   {{"cm", cm}, {"fallen", fallen}, {"advice", advice(face, *all.foam)}, {"more", more}});
    if (wrong == Wrong::thin)
        return say("thin_pads", {{"cm", cm},
                                 {"fallen", fallen},
                                 {"mm", number(all.foam->least_thickness_mm(), 1)},
                                 {"more", more}});
    return say("shock", {{"cm", cm},
                         {"fallen", fallen},
                         {"low", number(*face.g_low, 0)},
                         {"high", number(*face.g_high, 0)},
                         {"asked", number(*item.asked_g, 0)},
                         {"advice", advice(face, *all.foam)},
                         {"more", more}});
}

/// Of each wrong the worst item on a side, which stands for all.
void find_on_side(std::size_t side, const Protection& all, const Packing& packing,
                  std::vector<Finding>& findings) {
    for (const Wrong wrong : {Wrong::meets_item, Wrong::bottoms, Wrong::thin, Wrong::too_much}) {
        std::size_t count = 0, worst = 0;
        double most = -1;
        for (std::size_t i = 0; i < all.items.size(); ++i) {
            const ItemProtection& item = all.items[i];
            if (wrong_with(item.faces[side], item) != wrong) continue;
            ++count;
            const double share = item.faces[side].g_high.value_or(0) / item.asked_g.value_or(1);
            if (share <= most) continue;
            most = share;
            worst = i;
        }
        if (count == 0) continue;
        const ItemProtection& item = all.items[worst];
        findings.push_back({severity_of(wrong), sentence(wrong, item.faces[side], item, all, count - 1),
                            item.faces[side].peak_at,
                            packing.items.size() > 1 ? packing.items[worst].name : std::string()});
    }
}

/// The sentence for a reason that holds for a whole item; none where its faces speak for themselves.
const char* code_of(NoShock why) {
    switch (why) {
        case NoShock::no_foam_data:
            return "no_shock/foam";
        case NoShock::no_mass:
            return "no_shock/mass";
        case NoShock::no_height:
            return "no_shock/height";
        case NoShock::open:
            return "no_shock/open";
        case NoShock::unsettled:
            return "no_shock/unsettled";
        default:
            return nullptr;
    }
}

}  // namespace

void find_shocks(const Protection& all, const Packing& packing, std::vector<Finding>& findings) {
    for (std::size_t side = 0; side < 6; ++side) find_on_side(side, all, packing, findings);
    if (!all.rule && !all.drop_mm) return sort_by_severity(findings);  // no drop was asked for
    std::vector<const char*> told;
    for (const ItemProtection& item : all.items)
        for (const FaceShock& face : item.faces) {
            const char* const why = code_of(face.why_none);
            if (!why || std::find(told.begin(), told.end(), why) != told.end()) continue;
            told.push_back(why);
            findings.push_back({Severity::note, say(why)});
        }
    sort_by_severity(findings);
}

}  // namespace snug
