#pragma once

#include <vector>

#include "snug/check/packing.h"
#include "snug/check/protection_report.h"
#include "snug/object/object.h"

#include "wasm/values.h"

// Places that foam keeps away from, as the page has them (studio/src/engine/zones.ts).

namespace snug::wasm {

/// {zones: [{item, number, cut_blocks, text, reached, pressed}], findings}: what becomes of each; of the
/// packing's findings those of zones.
[[nodiscard]] val zones_val(const std::vector<ZoneReport>& zones, const Packing& packing);

/// Of each vertex of the object's mesh the number of its part, as zones name it; null where there is one
/// part alone, and where the mesh is a stand-in.
[[nodiscard]] val part_numbers(const Object& object);

}  // namespace snug::wasm
