#pragma once

#include <filesystem>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"
#include "snug/mesh/read.h"

namespace snug::cli {

/// snug::read_object with the tools of this machine and the files beside `path`. Errors of kind `input`,
/// without the file's name.
[[nodiscard]] Result<Mesh> read_object(Bytes file, const std::filesystem::path& path);

}  // namespace snug::cli
