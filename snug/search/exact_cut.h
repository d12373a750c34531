#pragma once

#include <array>
#include <optional>

#include "snug/design/design.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/foam/object_cut.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// What the method itself makes of a placement.
struct ExactCut {
    Placement placement;
    ObjectDepths depths;
    BlockMap blocks;
    long long cut_blocks = 0;
    std::array<double, 6> wall_mm{};  ///< as FitReport::wall_mm
};

/// None where the object, grown by its clearance, leaves the space or the blocks that exist in it
/// (`available`, in each column of the space).
[[nodiscard]] std::optional<ExactCut> exact_cut(const PreparedSurface& surface, const DesignSpace& space,
                                                const CutOptions& cut, Vec3d rotation_deg, Vec3d offset_mm,
                                                const Grid<Run>& available);

[[nodiscard]] bool keeps_walls(const std::array<double, 6>& wall_mm, const std::array<double, 6>& least_wall);

}  // namespace snug
