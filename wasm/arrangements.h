#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "snug/design/design.h"
#include "snug/object/object.h"

#include "wasm/values.h"

// Several things in one case, put where they take the least room.

namespace snug::wasm {

/// Whom it tells: `progress` of the share that is done, `better` of every better design, as its JSON text.
struct ArrangementListeners {
    val progress, better;
};

/// {choices}: the best arrangement, and after it some that differ (other_arrangements.h), each {design,
/// volume_mm3, lower_bound_mm3, layers, size_mm, plan}. plan: of each item {layer, min, max}, its bounds.
[[nodiscard]] val arrange(std::span<Object> objects, const Design& design,
                          const ArrangementListeners& listeners);

/// The same of the given space with as many of one item as go in; a single choice.
[[nodiscard]] val fill(std::span<Object> objects, const Design& design, std::size_t item,
                       const ArrangementListeners& listeners);

}  // namespace snug::wasm
