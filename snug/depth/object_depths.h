#pragma once

#include <optional>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/depth/depth_map.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// The surface as one half sees it, and how far that half keeps away from it.
struct HalfDepths {
    DepthMap depths;
    Reach reach;
};

struct ObjectDepths {
    HalfDepths lower;
    std::optional<HalfDepths> upper;  ///< none where it is the same
};

/// The depth maps of an object of any kind. Of a stream by a pass over its file for each half, which fails
/// where reading fails or is cancelled; the first marks the cubes of its stand-in where it has none yet.
[[nodiscard]] Result<ObjectDepths> object_depths(const Object& object, const Placement& placement,
                                                 const DesignSpace& space, const CutOptions& cut,
                                                 const Progress& progress = {});

/// Of a mesh; and for searches, which place the same surface many times.
[[nodiscard]] ObjectDepths object_depths(const Mesh& mesh, const Placement& placement,
                                         const DesignSpace& space, const CutOptions& cut);
[[nodiscard]] ObjectDepths object_depths(const PreparedSurface& surface, const Placement& placement,
                                         const DesignSpace& space, const CutOptions& cut);

}  // namespace snug
