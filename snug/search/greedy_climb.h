#pragma once

#include <array>
#include <functional>
#include <vector>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/depth/depth_map.h"
#include "snug/design/design.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// The paper's search for a better rotation (section 3.4): a greedy climb of the fill ratio F over the three
// Euler angles, from where they stand. The space does not change on the way, so F rises exactly when fewer
// blocks are cut, and those are compared as integers.

namespace snug {

/// A climb: what it may not change, and where it stands. Advance it with climb_round().
struct Climb {
    DesignSpace space;                   ///< stays that of the start, fitted or not
    CutOptions cut;                      ///< as the design has it
    std::vector<ItemZone> zones;         ///< of the object, as searched_zones() has them
    Vec3d offset_mm;                     ///< as the design has it
    Grid<Run> available;                 ///< blocks that exist in the space
    std::array<double, 6> least_wall{};  ///< mm on each side (FitReport::wall_mm): as wanted, or as at the
                                         ///< start where that was thinner

    Vec3d rotation_deg;         ///< the best so far; angles that were changed lie within -180 to 180
    long long cut_blocks = 0;   ///< there
    double fill_ratio = 0;      ///< there
    double step_deg = 16;       ///< how far the next round looks; below kLeastClimbStep the climb has ended
    long long evaluations = 0;  ///< placements looked at, the start included
};

constexpr double kLeastClimbStep = 1;  // degrees

[[nodiscard]] inline bool ended(const Climb& climb) {
    return climb.step_deg < kLeastClimbStep;
}

/// Is told after each evaluation; false cancels.
using ClimbProgress = std::function<bool(const Climb&)>;

/// Stands at the design's rotation. `space` is that of the packing there. Fails (kind does_not_fit) where the
/// object, grown by its clearance, or what its zones keep free leaves the space already.
[[nodiscard]] Result<Climb> start_climb(const PreparedSurface& surface, const Design& design,
                                        const DesignSpace& space, const std::vector<ItemZone>& zones = {});

/// Looks at the six rotations one step away, up and down each angle, and moves to the one that cuts the
/// fewest blocks (the first of equals) of those that cut fewer than now, stay inside the space and keep the
/// walls. Where there is none the step is halved. False if it was cancelled; the climb then stands at the
/// best of what was looked at.
bool climb_round(Climb& climb, const PreparedSurface& surface, const ClimbProgress& progress = {});

/// Rounds until the climb has ended or was cancelled: in both cases where it then stands, which is never
/// worse than the start. Fails as start_climb() does.
[[nodiscard]] Result<Climb> greedy_climb(const Mesh& mesh, const Design& design, const DesignSpace& space,
                                         const ClimbProgress& progress = {},
                                         const std::vector<ItemZone>& zones = {});

}  // namespace snug
