#include "snug/check/find_shocks.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/words/shocks.h"

namespace snug {
namespace {

/// What would do, as a part of a sentence.
Message advice(const FaceShock& face, const FoamMaterial& foam) {
    if (face.more_foam_mm)
        return foam.dynamic() ? say("shock.more_foam", {{"mm", number(*face.more_foam_mm, 0)}})
                              : say("shock.more_foam_or_data", {{"mm", number(*face.more_foam_mm, 0)}});
    return foam.dynamic() ? say("shock.other_foam") : say("shock.other_foam_or_data");
}

void find_on_face(const FaceShock& face, const ItemProtection& item, const Protection& all,
                  const std::string& of, std::vector<Finding>& findings) {
    const auto find = [&](Severity severity, Message message) {
        findings.push_back({severity, std::move(message), face.peak_at, of});
    };
    const std::string cm = number(*all.drop_mm / 10, 0);
    const Message fallen = fallen_on(face.face);
    if (face.meets_item) return find(Severity::danger, say("items_meet", {{"cm", cm}, {"fallen", fallen}}));
    if (face.bottoms && !face.bottoms_itself) return;  // it is said of the item that it reaches
    if (face.bottoms)
        return find(Severity::danger,
                    say("bottoms", {{"cm", cm}, {"fallen", fallen}, {"advice", advice(face, *all.foam)}}));
    if (face.why_none == NoShock::thin)
        return find(Severity::warning,
                    say("thin_pads",
                        {{"cm", cm}, {"fallen", fallen}, {"mm", number(all.foam->least_thickness_mm(), 1)}}));
    if (!face.g_high || !item.asked_g || *face.g_high <= *item.asked_g) return;
    find(Severity::warning, say("shock", {{"cm", cm},
                                          {"fallen", fallen},
                                          {"low", number(*face.g_low, 0)},
                                          {"high", number(*face.g_high, 0)},
                                          {"asked", number(*item.asked_g, 0)},
                                          {"advice", advice(face, *all.foam)}}));
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
        default:
            return nullptr;
    }
}

}  // namespace

void find_shocks(const Protection& all, const Packing& packing, std::vector<Finding>& findings) {
    std::vector<const char*> told;
    for (std::size_t i = 0; i < all.items.size(); ++i) {
        const std::string of = packing.items.size() > 1 ? packing.items[i].name : std::string();
        for (const FaceShock& face : all.items[i].faces) {
            const char* const why = code_of(face.why_none);
            if (!why)
                find_on_face(face, all.items[i], all, of, findings);
            else if (std::find(told.begin(), told.end(), why) == told.end()) {
                told.push_back(why);
                const bool for_height = face.why_none == NoShock::no_height;
                if (for_height && !all.rule) continue;  // none was asked for
                findings.push_back({Severity::note, say(why)});
            }
        }
    }
    sort_by_severity(findings);
}

}  // namespace snug
