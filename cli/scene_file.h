#pragma once

#include <filesystem>
#include <optional>

#include "snug/base/result.h"
#include "snug/formats/read.h"
#include "snug/mesh/mesh.h"

namespace snug::cli {

/// snug::read_object with the tools of this machine and the files beside `path`. Errors of kind `input`,
/// without the file's name.
[[nodiscard]] Result<Mesh> read_object(Bytes file, const std::filesystem::path& path);

/// What is wrong (kind `usage`) with --units, where it was typed for a file that states its unit itself.
[[nodiscard]] std::optional<Error> unwanted_units(const Mesh& mesh, bool typed);

}  // namespace snug::cli
