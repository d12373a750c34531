#pragma once

#include <optional>

#include "snug/check/find_relief.h"
#include "snug/check/packing.h"

#include "wasm/values.h"

// What beside pockets makes items fit, as the page has it.

namespace snug::wasm {

/// [{item, piece, above, box: {min, max}, text}], in the order of their numbers. `piece`: that it lies on, or
/// hangs under where it lies above its item; `text`: as the packing sheet lists it.
[[nodiscard]] val pads_val(const Packing& packing);

/// {height_mm, island_mm, finding}, or null.
[[nodiscard]] val relief_val(const std::optional<ReliefOffer>& offer, const Packing& packing);

/// Box in design coordinates: {min, max}.
[[nodiscard]] val box_val(const Box3d& box);

}  // namespace snug::wasm
