#pragma once

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/mesh/mesh.h"
#include "snug/pipeline.h"

// What pipeline.h does with a mesh, for a cloud of points: each counts as a ball (point_radius.h), and the
// foams give way to all balls, exactly.

namespace snug {

/// The rest of prepare(), for a cloud in mm. Rims of what the scanner did not see, such as the base, are
/// its holes; `hole_spans` are what closes them where the design wants caps (see capped()).
[[nodiscard]] Result<Object> prepare_cloud(Object object, Mesh cloud, const Design& design);

/// As pack().
[[nodiscard]] Result<Packing> pack_cloud(const Object& object, const Design& design);

}  // namespace snug
