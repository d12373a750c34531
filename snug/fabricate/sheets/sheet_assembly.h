#pragma once

#include <span>
#include <string>

#include "snug/drawing/drawing.h"
#include "snug/fabricate/sheets/dowel_holes.h"
#include "snug/fabricate/sheets/sheet_stack.h"

namespace snug {

/// What the assembly pages say of one half.
struct SheetAssembly {
    const SheetStack& stack;
    const DowelHoles& dowels;
    double thickness_mm = 0;
};

/// A length in the cutter's files that tells whether its program reads them at true size.
struct ScaleCheck {
    std::string file;     ///< "sheets/01.dxf"
    std::string piece;    ///< in it
    double width_mm = 0;  ///< of the piece's outline, along x
};

/// The pages sheets-assembly: for each half how to stack and glue it, then every sheet small with its number
/// and its islands, cavity facing the reader. `page_mm`: of the upright paper.
[[nodiscard]] DrawingDocument sheet_assembly(std::span<const SheetAssembly> halves, const FoamDesign& design,
                                             const SheetOptions& options, const ScaleCheck& check,
                                             Vec2d page_mm);

}  // namespace snug
