#pragma once

#include <optional>

#include "snug/base/message.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/design/design.h"
#include "snug/foam/relief_islands.h"
#include "snug/object/object.h"

namespace snug {

/// Why an item of this design cannot be relieved (`no_relief`), whatever its shape: several items, or foam
/// that is not a plank; none where it may be.
[[nodiscard]] std::optional<Message> never_relieved(const Design& design);

/// The only item of a packing, which may not have foams yet, as relief_islands() wants it. `own`: what it
/// cuts of the lower half. Fails as zone_columns() does.
[[nodiscard]] Result<RelievedItem> relieved_item(const Object& object, const Packing& packing,
                                                 const Design& design, const BlockMap& own);

/// The relief that the design wants, cut into `layer`; with a warning where there is none.
[[nodiscard]] Result<void> relieve(const Object& object, Packing& packing, const Design& design,
                                   const BlockMap& own, BlockMap& layer);

}  // namespace snug
