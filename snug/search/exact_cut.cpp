#include "snug/search/exact_cut.h"

#include <algorithm>
#include <cstddef>

#include "snug/check/fit_report.h"
#include "snug/foam/foams.h"
#include "snug/foam/zone_cuts.h"
#include "snug/search/searched_zones.h"
#include "snug/space/fitted_space.h"

namespace snug {

std::optional<ExactCut> exact_cut(const PreparedSurface& surface, const DesignSpace& space,
                                  const CutOptions& cut, Vec3d rotation_deg, Vec3d offset_mm,
                                  const Grid<Run>& available, const std::vector<ItemZone>& zones) {
    ExactCut result;
    const Item item = lying(surface, cut, zones, rotation_deg, offset_mm);
    result.placement = item.placement;
    const Vec3d least = fitted_blocks(room_of(item), space.block_mm);
    for (int axis = 0; axis < 3; ++axis)
        if (least[axis] > space.blocks[axis]) return {};
    result.depths = object_depths(surface, result.placement, space, cut);
    HalfCuts cuts = half_cuts(result.depths, space);
    // Of meshes it never fails.
    if (!cut_zones(item, 0, space, cuts)) return {};
    result.blocks = object_cut(cuts, space, result.placement.bounds);
    // Where the halves meet changes neither the walls nor what is cut.
    const FitReport fit =
        fit_report(split(result.blocks, 0, available), {&result.blocks, 1}, space, available);
    if (fit.outside_blocks > 0) return {};
    result.cut_blocks = fit.cut_blocks;
    result.fill_ratio = fit.fill_ratio;
    result.wall_mm = fit.wall_mm;
    return result;
}

bool keeps_walls(const std::array<double, 6>& wall_mm, const std::array<double, 6>& least_wall) {
    for (std::size_t side = 0; side < wall_mm.size(); ++side)
        if (wall_mm[side] < least_wall[side]) return false;
    return true;
}

}  // namespace snug
