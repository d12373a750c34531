#include "snug/design/sheet_options.h"

#include "snug/base/text.h"
#include "snug/design/option_list.h"

namespace snug {

std::optional<OptionProblem> problem_of(const SheetOptions& options) {
    if (auto found = out_of_range(options)) return found;
    if (2 * options.margin_mm >= options.stock_mm.x || 2 * options.margin_mm >= options.stock_mm.y)
        return OptionProblem{"margin_mm", "A margin of " + number(options.margin_mm) +
                                              " mm leaves nothing of a stock sheet of " +
                                              number(options.stock_mm.x) + " x " +
                                              number(options.stock_mm.y) + " mm; take larger sheets."};
    if (options.dowels > 0 && options.dowel_mm <= options.kerf_mm)
        return OptionProblem{"dowel_mm", "A dowel hole of " + number(options.dowel_mm) +
                                             " mm cannot be cut with a kerf of " + number(options.kerf_mm) +
                                             " mm; choose thicker dowels, or 0 dowels."};
    if (!options.svg && !options.dxf) return OptionProblem{"svg", "Choose SVG, DXF or both for the sheets."};
    return {};
}

}  // namespace snug
