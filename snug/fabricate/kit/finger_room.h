#pragma once

#include <array>

#include "snug/design/fit_options.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// The widest room for fingers beside the object at each side of the lower foam: back (-y), front (+y), left
/// (-z), right (+z).
struct FingerRoom {
    double mm = 0;  ///< from the foam to the object, seen from above
    Vec3d where;    ///< its middle, in design coordinates, at the parting; no place if mm is 0
};

/// Measured from above on a grid finer than the blocks, between the object's silhouette and the foam that
/// stands less than a finger's depth below the parting. Room that foam or object covers from above does not
/// count. Never too wide; too small by two cells (of about 2 mm) at most. `blocks`: what the object's layer
/// cuts, `below`: the piece under it, which ends at the level `parting` where nothing lies in it.
[[nodiscard]] std::array<FingerRoom, 4> finger_room(const Mesh& mesh, const Placement& placement,
                                                    const DesignSpace& space, const BlockMap& blocks,
                                                    const Grid<Run>& below, int parting);

}  // namespace snug
