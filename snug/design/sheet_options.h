#pragma once

#include <optional>
#include <string>

#include "snug/base/vec2.h"

namespace snug {

/// Foam cut into sheets that are glued on each other. Lengths in mm.
struct SheetOptions {
    std::optional<double> thickness_mm;  ///< of a sheet; none: a block's depth along x
    Vec2d stock_mm{1000, 600};           ///< a sheet of stock as it is sold, either way round
    double margin_mm = 5;                ///< left uncut along the edges of the stock, 0 or more
    double spacing_mm = 3;               ///< between two cuts of different pieces, 0 or more
    double kerf_mm = 0;                  ///< width that a cut takes away; 0: the cutter makes up for it
    double dowel_mm = 6;                 ///< diameter
    int dowels = 3;                      ///< holes in a half's sheets: 0, or 2 to 8
    double dowel_edge_mm = 6;            ///< least foam between a dowel hole and an edge
    bool svg = true;
    bool dxf = true;
    friend bool operator==(const SheetOptions& a, const SheetOptions& b) {
        return a.thickness_mm == b.thickness_mm && a.stock_mm.x == b.stock_mm.x &&
               a.stock_mm.y == b.stock_mm.y && a.margin_mm == b.margin_mm && a.spacing_mm == b.spacing_mm &&
               a.kerf_mm == b.kerf_mm && a.dowel_mm == b.dowel_mm && a.dowels == b.dowels &&
               a.dowel_edge_mm == b.dowel_edge_mm && a.svg == b.svg && a.dxf == b.dxf;
    }
};

/// What is out of range whatever the foam is, as a sentence; none where all is well.
[[nodiscard]] std::optional<std::string> problem_of(const SheetOptions& options);

}  // namespace snug
