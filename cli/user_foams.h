#pragma once

#include <filesystem>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/known_foams.h"

namespace snug::cli {

/// Where a user's own foams stand: foams.json beside the user's presets.
[[nodiscard]] std::filesystem::path user_foams_path();

/// The built-in foams, then the user's own where the file exists.
[[nodiscard]] Result<std::vector<FoamMaterial>> known_foams();

}  // namespace snug::cli
