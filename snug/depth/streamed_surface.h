#pragma once

#include <cstdint>
#include <optional>

#include "snug/base/box.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/rotation.h"
#include "snug/depth/depth_map.h"
#include "snug/formats/triangle_stream.h"
#include "snug/mesh/shell.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// How a file's coordinates become the object's: relative to an origin and in mm, rounded as a mesh in memory
/// has them.
struct FileToObject {
    Vec3d origin;
    double factor = 1;

    [[nodiscard]] Vec3f operator()(Vec3f p) const {
        if (!(origin == Vec3d{})) p = vec_cast<float>(vec_cast<double>(p) - origin);
        return factor == 1 ? p : vec_cast<float>(vec_cast<double>(p) * factor);
    }
};

/// What one pass over a file tells.
struct StreamedBounds {
    Box3d file;                   ///< of the coordinates as the file has them
    Box3d turned;                 ///< of the object's, turned
    std::uint64_t triangles = 0;  ///< those that are usable
};
[[nodiscard]] Result<StreamedBounds> streamed_bounds(const TriangleStream& stream, const FileToObject& object,
                                                     const Rotation& rotation, const Progress& progress = {});

/// As of a mesh (depth_map.h), to the bit, in one pass; the object's cubes are marked in the same pass, if
/// wanted.
[[nodiscard]] Result<DepthMap> depth_map(const TriangleStream& stream, const FileToObject& object,
                                         const Placement& placement, const DesignSpace& space, Reach reach,
                                         MetCubes* cubes = nullptr, const Progress& progress = {});

/// Marks the cubes alone. One pass.
[[nodiscard]] Result<void> mark_cubes(const TriangleStream& stream, const FileToObject& object,
                                      MetCubes& cubes, const Progress& progress = {});

}  // namespace snug
