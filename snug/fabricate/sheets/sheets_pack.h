#pragma once

#include "snug/base/result.h"
#include "snug/design/workshop_options.h"
#include "snug/fabricate/kit/workshop_pack.h"

namespace snug {

/// The foams as sheets, glued on each other from the case inwards: sheets/<stock>.svg and .dxf at true size,
/// sheets/index.csv (where each piece lies), fit-test.svg and .dxf, and the pages sheets-assembly on paper of
/// `page_mm`. Fails
/// (kind usage) where the options have no meaning for this foam, with what would work.
[[nodiscard]] Result<WorkshopPack> sheets_pack(const FoamDesign& design, const SheetOptions& options,
                                               Vec2d page_mm = paper_mm("a4"));

}  // namespace snug
