#pragma once

#include "snug/check/packing.h"
#include "snug/check/protection_report.h"

#include "wasm/values.h"

// What items meet in a drop, as the page has it.

namespace snug::wasm {

/// {foams: [{design, title, curve, status, source}], rules: [{name, title, verified}], classes: [{name, g,
/// source}], tray}: what can be chosen, and what
/// is said of a tray. `design`: the foam's JSON text as it stands in a design; `curve`: what is
/// known of how it pushes back, or null.
[[nodiscard]] val protection_choices();

/// What each item meets on each side and at rest, with what is left out, and the packing's findings.
[[nodiscard]] val to_val(const Protection& protection, const Packing& packing);

}  // namespace snug::wasm
