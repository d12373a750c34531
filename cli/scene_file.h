#pragma once

#include <filesystem>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"
#include "snug/mesh/read.h"

namespace snug::cli {

/// Whatever a file holds that Snug can pack: a mesh, a cloud, or the triangles of a glTF or 3MF scene, which
/// come in mm. Scenes are read by a process of their own, so that one that breaks its reader is only a file
/// that cannot be read. Errors of kind `input`, without the file's name.
[[nodiscard]] Result<Mesh> read_object(Bytes file, const std::filesystem::path& path);

}  // namespace snug::cli
