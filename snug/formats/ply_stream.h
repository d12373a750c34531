#pragma once

#include "snug/base/byte_source.h"
#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/formats/triangle_stream.h"

namespace snug {

/// A binary PLY as a TriangleStream: all its faces must be triangles. Its vertices are read here and kept as
/// floats; where the file has them as doubles two more passes find the origin that a mesh in memory would
/// have.
[[nodiscard]] Result<TriangleStream> open_ply_stream(ByteSource source, const Progress& progress = {});

}  // namespace snug
