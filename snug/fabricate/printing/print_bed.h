#pragma once

#include <span>
#include <vector>

#include "snug/base/vec.h"

namespace snug {

/// Where one of several things lies: on which bed, and its least corner there in mm.
struct BedPlace {
    int bed = 0;
    double x = 0, y = 0;
};

/// Lays things of these sizes (each no wider and deeper than the bed, in mm) out in rows, at least `gap_mm`
/// apart, on as many beds as it takes: deep ones first, each into the first row with room; or on fewer,
/// where those are found (search/mask_sheets.h).
[[nodiscard]] std::vector<BedPlace> places_on_beds(std::span<const Vec3d> sizes, Vec3d bed_mm,
                                                   double gap_mm = 5);

}  // namespace snug
