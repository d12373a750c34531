#include <cstddef>
#include <limits>

#include "snug/search/arranger.h"

// Of arrangements of equal volume the one whose items meet least in a drop.

namespace snug {

/// Compares `found` with a few others in the same room, each from `refined` by chance; the first of equals
/// stays. What cannot be packed is not taken.
void Arranger::take_least_shock(const ItemMasks& masks, const Found& refined, Found& found,
                                MaskPacker& packer) {
    constexpr int kOthers = 4, kIdleRounds = 60;
    const auto margin_of = [&](const Found& each) {
        const auto shocks = packed_shocks(objects_, written(masks, each), watch_.pack_it);
        return shocks ? worst_margin(shocks->protection) : std::numeric_limits<double>::infinity();
    };
    double least = margin_of(found);
    for (int i = 0; i < kOthers && !cancelled_; ++i) {
        Found other = refined;
        for (int moved = 0; moved <= i; ++moved) packer.disturb(other.room, other.layout);
        const long long most = work_ / 40;
        if (!packer.separate(other.room, other.layout, kIdleRounds, packer.work() + most)) continue;
        refine(masks, other, packer, most);
        finish(masks, other);
        const double margin = margin_of(other);
        if (!(margin < least)) continue;
        least = margin;
        found = other;
    }
}

}  // namespace snug
