#pragma once

#include <cstdint>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/mesh/mesh.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// The smallest case: the rotation and the fewest blocks that hold an object with its clearance, what its
// zones keep free, and walls. Only how long the turned object and its zones are along each axis counts, so
// the search runs on their outermost vertices. `zones`: as searched_zones() has them.

namespace snug {

struct FittedCase {
    Vec3d rotation_deg;
    Vec3i blocks;               ///< with the walls; the object lies in the middle
    long long evaluations = 0;  ///< rotations and cases looked at
};

/// Least volume (total blocks), or least billed weight: sides in whole centimetres, rounded up, over the
/// design's divisor, rounded up to half a kilogram; of equals the least volume. `design.space.blocks` does
/// not count, its walls do. Fails with kind `usage` where even this needs more than 4096 blocks on an axis,
/// and `cancelled`.
[[nodiscard]] Result<FittedCase> fit_case(const Mesh& mesh, const Design& design, std::uint64_t seed,
                                          const Progress& progress = {},
                                          const std::vector<ItemZone>& zones = {});

/// A rotation by which the object fits into a space with the wanted walls, or else without; its own first.
/// Fails (kind does_not_fit) where none does: the sentence says what is in the way.
[[nodiscard]] Result<Vec3d> fitting_rotation(const Mesh& mesh, const Design& design, const DesignSpace& space,
                                             std::uint64_t seed, const std::vector<ItemZone>& zones = {});

}  // namespace snug
