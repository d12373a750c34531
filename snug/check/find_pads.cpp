#include "snug/check/find_pads.h"

#include <algorithm>
#include <cstddef>

#include "snug/base/text.h"
#include "snug/check/gravity.h"

namespace snug {
namespace {

bool lies_under_pad(const Packing& packing, std::size_t item) {
    return std::any_of(packing.pads.pads.begin(), packing.pads.pads.end(),
                       [&](const FillPad& pad) { return pad.above && pad.item == item; });
}

void find_pressing(const Packing& packing, std::size_t item, std::vector<Finding>& findings) {
    const std::string of = packing.items.size() > 1 ? packing.items[item].name : std::string();
    if (!packing.protection || !packing.protection->items[item].pressed_n) {
        findings.push_back({Severity::warning, say("pads_press_unknown", {{"flag", "--foam"}}), {}, of});
        return;
    }
    const double newton = *packing.protection->items[item].pressed_n;
    if (newton < 0.05) return;
    const Message text =
        say("pads_press", {{"newton", number(newton, 1)}, {"kg", number(newton / kStandardGravity, 2)}});
    const auto& kg = packing.items[item].mass_kg;
    const bool heavy = kg && newton > *kg * kStandardGravity;
    findings.push_back({heavy ? Severity::warning : Severity::note, text, {}, of});
}

}  // namespace

void find_pads(const Packing& packing, const PadOptions& options, std::vector<Finding>& findings) {
    const FillPads& pads = packing.pads;
    if (!pads.pads.empty())
        findings.push_back({Severity::note, say("pads", {{"pads", pads.pads.size()}}), {}, {}});
    if (pads.left_out > 0)
        findings.push_back({Severity::note, say("pads_left_out", {{"pads", pads.left_out}}), {}, {}});
    if (options.squeeze_mm > 0)
        for (std::size_t i = 0; i < packing.items.size(); ++i)
            if (lies_under_pad(packing, i)) find_pressing(packing, i, findings);
    sort_by_severity(findings);
}

}  // namespace snug
