#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/check/contact_map.h"
#include "snug/check/packing.h"
#include "snug/check/protection_report.h"

#include "wasm/values.h"

// What items meet in a drop, as the page has it.

namespace snug::wasm {

/// {foams: [{design, title, curve, status, source}], rules: [{name, title, verified}], classes: [{name, g,
/// source}], tray, walls_mm}: what can be chosen, what
/// is said of a tray, and the foam that is usual around things, by who carries them. `design`: the foam's
/// JSON text as it stands in a design; `curve`: what is known of how it pushes back, or null.
[[nodiscard]] val protection_choices();

/// {foams}, as above, from the text of a person's own file (known_foams.h), or what is wrong with it.
[[nodiscard]] val foams_val(const std::string& text);

/// What each item meets on each side and at rest, with what is left out, and the packing's findings.
/// `fitting`: what else follows from drops, of pads and reliefs.
[[nodiscard]] val to_val(const Protection& protection, const Packing& packing,
                         const std::vector<Finding>& fitting);

/// {axis, rows, columns, cell_mm: [along axis + 1, along axis + 2], items: [{why, columns}]}: `why`: the
/// sentence where nothing is known, else null; `columns`: of each of them row, column, 1 before the item's
/// high end and 0 before its low one, from_mm, to_mm, strain and kPa, as contact_map.h has them.
[[nodiscard]] val contacts_val(const ContactMap& map, const Protection& all, std::optional<Side> side);

}  // namespace snug::wasm
