#pragma once

#include "snug/base/vec.h"
#include "snug/design/design.h"

namespace snug {

/// From the file's unit to millimetres, for an object of this size in the file's unit. `in_mm`: the file
/// states its unit, so it is in mm already.
[[nodiscard]] double millimetres_per_unit(Vec3d size, const ObjectOptions& options, bool in_mm = false);

}  // namespace snug
