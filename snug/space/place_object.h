#pragma once

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/vec.h"
#include "snug/object/object.h"
#include "snug/space/placement.h"

namespace snug {

/// Where an object of any kind lies, by Euler angles and an offset in mm (placement.h). A streamed object
/// that was turned otherwise when it was prepared takes a pass over its file. Fails only there, where reading
/// fails or is cancelled.
[[nodiscard]] Result<Placement> place(const Object& object, Vec3d rotation_deg, Vec3d offset_mm,
                                      const Progress& progress = {});

}  // namespace snug
