#pragma once

#include <cstdint>

#include "snug/base/box.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/check/gap_space.h"

namespace snug {

/// A ball, and how much larger the largest one may be; radius 0 where none was found.
struct LargestBall {
    Vec3d centre;
    double radius = 0;
    double radius_error = 0;  ///< guaranteed: no ball's radius exceeds radius + radius_error
};

struct LargestBallOptions {
    double relative_error = 0.02;   ///< the search ends when the radius is known to this part of itself...
    double absolute_error = 0.125;  ///< ...or to this, in mm, whichever is larger
    int most_probes = 200'000;      ///< ...or when so many points were probed...
    /// ...or when that took so many looks at boxes, prisms and triangles (which count as several);
    /// radius_error then tells. Objects that people pack take a fraction of this.
    std::uint64_t most_work = std::uint64_t{1} << 25;
};

/// A bound that the room of no point in the cube exceeds, from a probe of its centre. `half`: half the cube's
/// side.
[[nodiscard]] double greatest_room(const GapSpace::Probe& probe, Vec3d centre, double half);

/// The largest ball in the gap whose centre lies in `bounds`, by branch and bound: boxes are halved, the most
/// promising first, until none can hold the centre of a ball that is larger by more than the error. Fails
/// only when cancelled.
[[nodiscard]] Result<LargestBall> largest_ball(const GapSpace& gap, const Box3d& bounds,
                                               const LargestBallOptions& options = {},
                                               const Progress& progress = {});

}  // namespace snug
