#pragma once

#include "snug/base/result.h"
#include "snug/design/sheet_options.h"
#include "snug/fabricate/workshop_pack.h"

namespace snug {

/// The foams as sheets, glued on each other from the case inwards: sheets/<stock>.svg and .dxf at true size,
/// sheets/index.csv (where each piece lies), fit-test.svg and .dxf, and the pages sheets-assembly. Fails
/// (kind usage) where the options have no meaning for this foam, with what would work.
[[nodiscard]] Result<WorkshopPack> sheets_pack(const FoamDesign& design, const SheetOptions& options);

}  // namespace snug
