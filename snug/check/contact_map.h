#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/side.h"
#include "snug/base/vec2.h"
#include "snug/check/packing.h"
#include "snug/check/protection_report.h"
#include "snug/object/object.h"

namespace snug {

/// A column of foam that an item squeezes.
struct PressedColumn {
    std::int32_t row = 0, column = 0;  ///< the cell that it stands for, see ContactMap
    double u_mm = 0, v_mm = 0;         ///< where it stands along axis + 1 and axis + 2 (mod 3)
    bool high = false;                 ///< it lies before the item's high end
    /// Along the axis, design coordinates: the foam lies between. The item ends at the first of a column
    /// before its high end, at the second of one before its low end.
    double from_mm = 0, to_mm = 0;
    double area_mm2 = 0;
    double strain = 0;  ///< above 0
    double kpa = 0;
};

/// What squeezes what, of one item.
struct ItemContacts {
    NoShock why_none = NoShock::none;  ///< then there are no columns
    std::vector<PressedColumn> columns;
};

/// Pressure on every item and strain of the foam beside it, line by line, as the report has its items lie:
/// with the curve as it is given, columns of foam as springs of their own, no friction.
struct ContactMap {
    int axis = 0;
    /// Cells side by side from the space's low faces: rows along axis + 1, columns along axis + 2, of this
    /// size.
    int rows = 0, columns = 0;
    Vec2d cell_mm;
    std::vector<ItemContacts> items;  ///< of each item of the packing
};

/// Where each item meets its most in the drop on `side`, or at rest where there is none. `all`: what
/// protection() found of the packing. Fails only when cancelled.
[[nodiscard]] Result<ContactMap> contact_map(std::span<const Object> objects, const Packing& packing,
                                             const Protection& all, std::optional<Side> side,
                                             const Progress& progress = {});

}  // namespace snug
