#include "snug/search/shock_wishes.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/check/protection.h"

namespace snug {

std::optional<Error> lacking_for_shocks(const Design& design, const Message& wish) {
    const ProtectionOptions& options = design.protection;
    const bool borne =
        options.asked_g() || std::all_of(design.items.begin(), design.items.end(),
                                         [](const ItemOptions& item) { return item.fragility_g; });
    std::vector<Message> what;
    if (!mass_kg(design)) what.push_back(say("protect.lacks/mass"));
    if (!options.drops()) what.push_back(say("protect.lacks/drop"));
    if (!borne) what.push_back(say("protect.lacks/borne"));
    if (!options.foam || options.foam->curve.empty()) what.push_back(say("protect.lacks/foam"));
    if (what.empty()) return {};
    return Error{ErrorKind::usage,
                 say("protect.lacking", {{"wish", std::vector<Message>{wish}}, {"what", what}})};
}

std::optional<Error> lacking_for_search(const Design& design) {
    if (!design.search.weighs(Objective::shock)) return {};
    return lacking_for_shocks(design, say("protect.wish/shock"));
}

Result<PackedShocks> packed_shocks(std::span<const Object> objects, const Design& design,
                                   const PackIt& pack_it) {
    auto packing = pack_it(design);
    if (!packing) return tl::unexpected(packing.error());
    if (!packing->foams)
        return fail(ErrorKind::does_not_fit,
                    say("search.leaves_space", {{"space", dimensions(packing->space.size())}}));
    auto found = protection(objects, *packing, design);
    if (!found) return tl::unexpected(found.error());
    if (!found->drop_mm) return fail(ErrorKind::usage, say("no_shock/height"));
    return PackedShocks{std::move(*packing), std::move(*found)};
}

double worst_margin(const Protection& protection) {
    const std::array<double, 6> margins = protection.margins();
    return *std::max_element(margins.begin(), margins.end());
}

}  // namespace snug
