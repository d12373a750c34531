#pragma once

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/mesh/mesh.h"
#include "snug/object/object.h"

namespace snug {

/// The rest of prepare(), for a cloud in mm. Rims of what the scanner did not see, such as the base, are its
/// holes; what is missing is what closes them where the design wants caps (see capped()).
[[nodiscard]] Result<Object> prepare_cloud(Object object, Mesh cloud, const Design& design);

}  // namespace snug
