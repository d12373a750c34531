#pragma once

#include <cstdint>

#include "snug/base/box.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/base/rotation.h"
#include "snug/formats/triangle_stream.h"
#include "snug/object/triangle_groups.h"

namespace snug {

/// What one pass over a file tells.
struct StreamedBounds {
    Box3d file;                   ///< of the coordinates as the file has them
    Box3d turned;                 ///< of the object's, turned
    std::uint64_t triangles = 0;  ///< those that are usable
};
[[nodiscard]] Result<StreamedBounds> streamed_bounds(const TriangleStream& stream, const FileToObject& object,
                                                     const Rotation& rotation, const Progress& progress = {});

/// Marks the cubes that the object meets. One pass.
[[nodiscard]] Result<void> mark_cubes(const TriangleStream& stream, const FileToObject& object,
                                      MetCubes& cubes, const Progress& progress = {});

}  // namespace snug
