#include "snug/design/sheet_options.h"

#include "snug/base/text.h"

namespace snug {
namespace {

constexpr double kGreatest = 1e5;  // mm

/// Also false for what is no number.
bool within(double value, double least, double most) {
    return value >= least && value <= most;
}

}  // namespace

std::optional<std::string> problem_of(const SheetOptions& options) {
    if (options.thickness_mm && !within(*options.thickness_mm, 0.1, kGreatest))
        return "A sheet's thickness must be 0.1 mm or more; leave it out for the depth of a block.";
    if (!within(options.stock_mm.x, 1, kGreatest) || !within(options.stock_mm.y, 1, kGreatest))
        return "A stock sheet's sides must be 1 to 100,000 mm, for instance 1000 x 600.";
    if (!within(options.margin_mm, 0, kGreatest) || !within(options.spacing_mm, 0, kGreatest))
        return "The stock's margin and the spacing between pieces must be 0 mm or more.";
    if (2 * options.margin_mm >= options.stock_mm.x || 2 * options.margin_mm >= options.stock_mm.y)
        return "A margin of " + number(options.margin_mm) + " mm leaves nothing of a stock sheet of " +
               number(options.stock_mm.x) + " x " + number(options.stock_mm.y) + " mm; take larger sheets.";
    if (!within(options.kerf_mm, 0, kGreatest))
        return "The kerf must be 0 mm (the cutter makes up for it) or more; lasers take 0.1 to 0.3 mm.";
    if (options.dowels != 0 && (options.dowels < 2 || options.dowels > 8))
        return "Sheets take 2 to 8 dowels, or 0 for none; " + std::to_string(options.dowels) +
               " cannot hold them in place.";
    if (options.dowels > 0 && !within(options.dowel_mm, 0.5, 1000))
        return "A dowel's diameter must be 0.5 to 1,000 mm; 6 mm is usual.";
    if (options.dowels > 0 && options.dowel_mm <= options.kerf_mm)
        return "A dowel hole of " + number(options.dowel_mm) + " mm cannot be cut with a kerf of " +
               number(options.kerf_mm) + " mm; choose thicker dowels, or 0 dowels.";
    if (!within(options.dowel_edge_mm, 0, kGreatest))
        return "The foam between a dowel hole and an edge must be 0 mm or more.";
    if (!options.svg && !options.dxf) return "Choose SVG, DXF or both for the sheets.";
    return {};
}

}  // namespace snug
