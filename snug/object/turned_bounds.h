#pragma once

#include "snug/base/box.h"
#include "snug/base/rotation.h"
#include "snug/object/prepared_surface.h"

namespace snug {

/// The bounding box of the turned vertices, the same to the bit as that of a pass over all of them: only
/// clusters that may reach furthest are looked at. Empty where there are none.
[[nodiscard]] Box3d turned_bounds(const SurfaceClusters& surface, const Rotation& rotation);

}  // namespace snug
