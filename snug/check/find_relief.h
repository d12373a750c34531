#pragma once

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

/// Where only less foam under an only item would make its drop on the floor enough: the islands that come to
/// the least shock of those that would, as `relief_offer` (note) among the packing's findings. Nothing where
/// the design has a relief, or where none helps. Fails as cut_items() does.
[[nodiscard]] Result<void> offer_relief(std::span<const Object> objects, const Design& design,
                                        Packing& packing);

}  // namespace snug
