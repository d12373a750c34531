#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/design/design.h"
#include "snug/object/object.h"

namespace snug {

/// Of a packing whose item stands on islands: `relief` (note) that tells them; `relief_bottoms` (danger)
/// where a fifth more mass from a quarter higher may bottom; where at rest more presses on them than half of
/// what the foam bears for long `relief_creep` (warning), and where that is not known `relief_creep_unknown`
/// (note).
void find_relief(const Packing& packing, const Design& design, std::vector<Finding>& findings);

/// Islands for a design that has none, and what they would do: `relief_offer` (note).
struct ReliefOffer {
    ReliefOptions options;
    Finding finding;
};

/// Where the drop of an only item on its floor is not shown to be enough, and less foam under it would lower
/// its shock: the islands that come to the least of those that were tried. None where the design has a
/// relief, where its drops were not looked at, or where none helps. Fails as cut_items() does.
[[nodiscard]] Result<std::optional<ReliefOffer>> offered_relief(std::span<const Object> objects,
                                                                const Design& design, const Packing& packing);

}  // namespace snug
