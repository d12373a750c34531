#pragma once

#include <string>
#include <vector>

#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/fabricate/sheets/sheet_assembly.h"

namespace snug {

/// What a half's sheets cannot do: foam lost to thick sheets, islands, pieces that would fall out, sheets
/// without dowels.
void add_sheet_findings(std::vector<Finding>& findings, const FoamDesign& design, const SheetAssembly& half,
                        const SheetOptions& options);

/// Pieces too small for their number.
void add_unnumbered_finding(std::vector<Finding>& findings, const std::vector<std::string>& pieces);

/// "L2a, L2b and U1a", or the first of them and how many there are more: "L3a, L3b and 5 more".
[[nodiscard]] Message listed(const std::vector<std::string>& pieces, std::size_t most);

/// Islands of the sheets above the first; with `first` those of the first sheet, which no sheet holds.
[[nodiscard]] std::vector<std::string> island_names(const SheetStack& stack, bool first);

}  // namespace snug
