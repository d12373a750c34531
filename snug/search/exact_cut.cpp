#include "snug/search/exact_cut.h"

#include <algorithm>
#include <cstddef>

#include "snug/check/fit_report.h"
#include "snug/foam/foams.h"
#include "snug/space/fitted_space.h"

namespace snug {

std::optional<ExactCut> exact_cut(const PreparedSurface& surface, const DesignSpace& space,
                                  const CutOptions& cut, Vec3d rotation_deg, Vec3d offset_mm,
                                  const Grid<Run>& available) {
    ExactCut result;
    result.placement = place(surface, rotation_deg, offset_mm);
    const Vec3d least =
        fitted_blocks(grown(result.placement.bounds, cut.whole_clearance_mm()), space.block_mm);
    for (int axis = 0; axis < 3; ++axis)
        if (least[axis] > space.blocks[axis]) return {};
    result.depths = object_depths(surface, result.placement, space, cut);
    result.blocks = object_cut(half_cuts(result.depths, space), space, result.placement.bounds);
    // Where the halves meet changes neither the walls nor what is cut.
    const FitReport fit =
        fit_report(split(result.blocks, 0, available), {&result.blocks, 1}, space, available);
    if (fit.outside_blocks > 0) return {};
    result.cut_blocks = fit.cut_blocks;
    result.wall_mm = fit.wall_mm;
    return result;
}

bool keeps_walls(const std::array<double, 6>& wall_mm, const std::array<double, 6>& least_wall) {
    for (std::size_t side = 0; side < wall_mm.size(); ++side)
        if (wall_mm[side] < least_wall[side]) return false;
    return true;
}

}  // namespace snug
