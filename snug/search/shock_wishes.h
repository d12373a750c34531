#pragma once

#include <functional>
#include <optional>
#include <span>

#include "snug/base/message.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/check/protection_report.h"
#include "snug/design/design.h"
#include "snug/object/object.h"

// What whoever chooses by shocks asks for.

namespace snug {

/// Packs the objects at hand by a design, see pack() in make.h.
using PackIt = std::function<Result<Packing>(const Design&)>;

/// What is missing for a shock to be compared with what an item bears: kind `usage`; none where the design
/// says a foam of known curve, every mass, a drop and what every item must bear. `wish`: how the sentence
/// begins, who needs it.
[[nodiscard]] std::optional<Error> lacking_for_shocks(const Design& design, const Message& wish);

/// The same of a search or an arrangement; none where its design does not weigh shocks, either.
[[nodiscard]] std::optional<Error> lacking_for_search(const Design& design);

/// Packed by the design, and what is met in a drop, by the full calculation. Fails as pack() does, with kind
/// `does_not_fit` where an item leaves the space, and with kind `usage` where no height is known.
struct PackedShocks {
    Packing packing;
    Protection protection;
};
[[nodiscard]] Result<PackedShocks> packed_shocks(std::span<const Object> objects, const Design& design,
                                                 const PackIt& pack_it);

/// The worst of all margins.
[[nodiscard]] double worst_margin(const Protection& protection);

}  // namespace snug
