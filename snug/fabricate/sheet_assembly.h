#pragma once

#include <span>

#include "snug/fabricate/dowel_holes.h"
#include "snug/fabricate/drawing.h"
#include "snug/fabricate/sheet_stack.h"

namespace snug {

/// What the assembly pages say of one half.
struct SheetAssembly {
    const SheetStack& stack;
    const DowelHoles& dowels;
    double thickness_mm = 0;
};

/// The pages sheets-assembly: for each half how to stack and glue it, then every sheet small with its number
/// and its islands, cavity facing the reader.
[[nodiscard]] DrawingDocument sheet_assembly(std::span<const SheetAssembly> halves,
                                             const std::string& object_name, const SheetOptions& options);

}  // namespace snug
