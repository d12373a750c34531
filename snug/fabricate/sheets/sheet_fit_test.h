#pragma once

#include <optional>

#include "snug/design/sheet_options.h"
#include "snug/drawing/drawing.h"
#include "snug/fabricate/kit/fit_test.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// The thinnest ring that proves the object's outline (fit_test.h) as one sheet to cut, seen as the lower
/// foam is, engraved FIT with an arrow to BACK. Pieces of a ring that is open lie beside each other. None
/// where no sheet is large enough.
[[nodiscard]] std::optional<Drawing> sheet_fit_test(const FitTest& test, const FoamDesign& design,
                                                    const SheetOptions& options);

}  // namespace snug
