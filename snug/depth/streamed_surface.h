#pragma once

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/depth/depth_map.h"
#include "snug/formats/triangle_stream.h"
#include "snug/mesh/shell.h"
#include "snug/object/triangle_groups.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// As of a mesh (depth_map.h), to the bit, in one pass; the object's cubes are marked in the same pass, if
/// wanted.
[[nodiscard]] Result<DepthMap> depth_map(const TriangleStream& stream, const FileToObject& object,
                                         const Placement& placement, const DesignSpace& space, Reach reach,
                                         MetCubes* cubes = nullptr, const Progress& progress = {});

}  // namespace snug
