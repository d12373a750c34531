#pragma once

#include <filesystem>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/presets.h"

namespace snug::cli {

/// Where a user's own presets stand: $XDG_CONFIG_HOME/snug/presets.json, else ~/.config/snug/presets.json.
[[nodiscard]] std::filesystem::path user_presets_path();

/// The built-in presets, then the user's own where the file exists.
[[nodiscard]] Result<std::vector<Preset>> known_presets();

}  // namespace snug::cli
