#pragma once

#include <functional>
#include <optional>

#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/design/design.h"
#include "snug/search/shock_wishes.h"

namespace snug {

/// How an object lies so that its worst side meets least for what it bears (worst_margin()).
struct ShockPose {
    Vec3d rotation_deg;
    double margin = 0;
    int looked_at = 0;  ///< poses, each by the full calculation
    bool cancelled = false;
};

/// Where counts are left open: of the rotations that the search allows, each in the space that it needs with
/// the walls that are wanted. Coarse, spread evenly, and then small turns of the best; what lies in a space
/// by then is for placement_search.h. `news`: is told the share that is done; false cancels. Fails as
/// packed_shocks() does for the rotation that is given.
[[nodiscard]] Result<ShockPose> pose_of_least_shock(const Object& object, const Design& design,
                                                    const PackIt& pack_it,
                                                    const std::function<bool(double)>& news = {});

}  // namespace snug
