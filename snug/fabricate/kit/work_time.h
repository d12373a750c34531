#pragma once

#include "snug/design/workshop_options.h"

namespace snug {

/// How long a pair of hands is busy with one piece of a pack (PackMaterial::pieces), in seconds: pulling out
/// a block of sponge, cutting a sheet to contour and laying it, clearing up a printed part, pressing on a
/// brick, clamping what is milled, pouring and freeing a cast. Guesses, until somebody has timed their own.
[[nodiscard]] double seconds_each(Workshop work);

}  // namespace snug
