#include "snug/design/sheet_options.h"

#include "snug/base/text.h"
#include "snug/design/option_list.h"

namespace snug {

double wanted_thickness_mm(const SheetOptions& options, double block_depth_mm) {
    return options.thickness_mm.value_or(block_depth_mm);
}

std::optional<OptionProblem> problem_of(const SheetOptions& options) {
    if (auto found = out_of_range(options)) return found;
    if (2 * options.margin_mm >= options.stock_mm.x || 2 * options.margin_mm >= options.stock_mm.y)
        return OptionProblem{"margin_mm", say("sheet.margin", {{"margin", number(options.margin_mm)},
                                                               {"stock", number(options.stock_mm.x) + " x " +
                                                                             number(options.stock_mm.y)}})};
    if (options.dowels > 0 && options.dowel_mm <= options.kerf_mm)
        return OptionProblem{"dowel_mm", say("sheet.kerf", {{"dowel", number(options.dowel_mm)},
                                                            {"kerf", number(options.kerf_mm)}})};
    if (!options.svg && !options.dxf) return OptionProblem{"svg", say("sheet.no_kind")};
    return {};
}

}  // namespace snug
