#include "cli/user_presets.h"

#include <cstdlib>

#include "snug/words/words.h"

namespace snug::cli {

namespace fs = std::filesystem;

fs::path user_presets_path() {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    const fs::path base = config && *config ? fs::path(config) : fs::path(home ? home : ".") / ".config";
    return base / "snug" / "presets.json";
}

Result<std::vector<Preset>> known_presets() {
    std::vector<Preset> presets = built_in_presets();
    const auto own = read_own<Preset>(user_presets_path(), parse_presets);
    if (!own) return tl::unexpected(own.error());
    presets.insert(presets.end(), own->begin(), own->end());
    return presets;
}

}  // namespace snug::cli
