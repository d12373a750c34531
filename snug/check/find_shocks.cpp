#include "snug/check/find_shocks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "snug/check/drop_sentence.h"

namespace snug {
namespace {

Severity severity_of(DropVerdict verdict) {
    return verdict == DropVerdict::meets_item || verdict == DropVerdict::bottoms ? Severity::danger
                                                                                 : Severity::warning;
}

/// `others`: of how many items more the same is true.
Message sentence(DropVerdict verdict, const FaceShock& face, const ItemProtection& item,
                 const Protection& all, std::size_t others) {
    const Message drop = drop_sentence(face, item, all);
    const Message advice = drop_advice(face, item, all).value();
    std::vector<Message> more;
    if (others > 0) more.push_back(say("shock.others", {{"items", others}}));
    if (verdict == DropVerdict::meets_item)
        return say("items_meet", {{"drop", drop}, {"more", more}, {"advice", advice}});
    if (verdict == DropVerdict::bottoms)
        return say("bottoms", {{"drop", drop}, {"more", more}, {"advice", advice}});
    if (verdict == DropVerdict::thin)
        return say("thin_pads", {{"drop", drop}, {"more", more}, {"advice", advice}});
    return say("shock", {{"drop", drop}, {"more", more}, {"advice", advice}});
}

/// Of each wrong the worst item on a side, which stands for all.
void find_on_side(std::size_t side, const Protection& all, const Packing& packing,
                  std::vector<Finding>& findings) {
    for (const DropVerdict wrong :
         {DropVerdict::meets_item, DropVerdict::bottoms, DropVerdict::thin, DropVerdict::over}) {
        std::size_t count = 0, worst = 0;
        double most = -1;
        for (std::size_t i = 0; i < all.items.size(); ++i) {
            const ItemProtection& item = all.items[i];
            const FaceShock& face = item.faces[side];
            // What another item bottoms on is said of that one.
            if (face.bottoms && !face.bottoms_itself && !face.meets_item) continue;
            if (verdict_on(face, item) != wrong) continue;
            ++count;
            const double share = face.g_high.value_or(0) / item.asked_g.value_or(1);
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

}  // namespace

void find_shocks(const Protection& all, const Packing& packing, std::vector<Finding>& findings) {
    for (std::size_t side = 0; side < 6; ++side) find_on_side(side, all, packing, findings);
    if (!all.rule && !all.drop_mm) return sort_by_severity(findings);  // no drop was asked for
    std::vector<NoShock> told;
    for (const ItemProtection& item : all.items)
        for (const FaceShock& face : item.faces) {
            const auto why = no_shock_text(face.why_none);
            if (!why || std::find(told.begin(), told.end(), face.why_none) != told.end()) continue;
            told.push_back(face.why_none);
            findings.push_back({Severity::note, *why});
        }
    sort_by_severity(findings);
}

}  // namespace snug
