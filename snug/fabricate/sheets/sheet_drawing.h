#pragma once

#include <span>
#include <string>
#include <vector>

#include "snug/drawing/drawing.h"
#include "snug/fabricate/sheets/cut_piece.h"
#include "snug/fabricate/sheets/nesting.h"

namespace snug {

/// The layer of lines that a knife slits, not through.
constexpr const char* kSlitLayer = "slit";

/// One sheet of stock at true size. Layers in the order of work: engrave, mark (the outline of the sheet
/// above), kSlitLayer where there are any, cut-inner, cut-outer. Pieces within others' offcuts are wholly on
/// cut-inner, smallest first, so that nothing is cut that has already fallen out.
[[nodiscard]] Drawing stock_drawing(std::span<const CutPiece> pieces, const Nesting& nesting, int stock,
                                    const Message& title, Language language);

}  // namespace snug
