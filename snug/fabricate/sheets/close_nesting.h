#pragma once

#include <optional>
#include <span>

#include "snug/fabricate/sheets/nesting.h"

namespace snug {

/// Nested closer than by their bounding boxes: pieces reach into each other's notches and holes as far as
/// their cells let them, on a lattice that the gap between cuts is almost a multiple of
/// (search/mask_sheets.h). `known`: a nesting of these pieces; the result lies on stock of its way round, on
/// as many stocks or fewer of each colour, and uses less of it. None where nothing better was found with some
/// tenths of a second of work.
[[nodiscard]] std::optional<Nesting> closer_nesting(std::span<const PieceToNest> pieces, Vec2d cell_mm,
                                                    const SheetOptions& options, const Nesting& known);

}  // namespace snug
