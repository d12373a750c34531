#pragma once

#include <optional>

#include "snug/fabricate/mill/carved_stock.h"
#include "snug/fabricate/mill/mill.h"

namespace snug {

/// The most that foam may stand in each fine cell of the stock, in steps: within the case, and below the
/// object grown by its clearance anywhere in the cell, exactly (depth_map.h on the fine cells). Without an
/// object no more than the field.
[[nodiscard]] Grid<int> allowed_heights(const FoamDesign& design, Piece piece, const MillField& field,
                                        const CarvedStock& stock, const std::optional<MilledObject>& object);
/// The same for the other side: within the case, above the items of the layers below, and anything where
/// nothing is left of the foam.
[[nodiscard]] Grid<int> allowed_outside(const FoamDesign& design, Piece piece, const MillField& field,
                                        const CarvedStock& stock, const std::optional<MilledObject>& object);
/// No more than the field.
[[nodiscard]] Grid<int> field_heights(const MillField& field, const CarvedStock& stock);

}  // namespace snug
