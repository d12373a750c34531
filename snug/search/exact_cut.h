#pragma once

#include <array>
#include <optional>
#include <vector>

#include "snug/design/design.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/foam/object_cut.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"
#include "snug/space/placement.h"

namespace snug {

/// What the method itself makes of a placement.
struct ExactCut {
    Placement placement;
    ObjectDepths depths;  ///< of the object alone
    BlockMap blocks;      ///< what it cuts and its zones beside
    long long cut_blocks = 0;
    double fill_ratio = 0;            ///< as FitReport has it
    std::array<double, 6> wall_mm{};  ///< as FitReport::wall_mm
};

/// None where the object, grown by its clearance, or what its zones keep free leaves the space or the blocks
/// that exist in it (`available`, in each column of the space). `zones`: as searched_zones() has them.
[[nodiscard]] std::optional<ExactCut> exact_cut(const PreparedSurface& surface, const DesignSpace& space,
                                                const CutOptions& cut, Vec3d rotation_deg, Vec3d offset_mm,
                                                const Grid<Run>& available,
                                                const std::vector<ItemZone>& zones = {});

[[nodiscard]] bool keeps_walls(const std::array<double, 6>& wall_mm, const std::array<double, 6>& least_wall);

}  // namespace snug
