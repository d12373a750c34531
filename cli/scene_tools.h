#pragma once

#include <filesystem>

#include "snug/formats/scene_tools.h"

namespace snug::cli {

/// What scene readers ask for, natively: files from the scene's own folder and below, zlib, meshoptimizer and
/// Draco (draco_process.h).
[[nodiscard]] SceneTools scene_tools(const std::filesystem::path& scene);

}  // namespace snug::cli
