#include "cli/user_presets.h"

#include <cstdlib>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/files.h"

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
    const fs::path path = user_presets_path();
    std::error_code error;
    if (!fs::exists(path, error)) return presets;
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto own = parse_presets({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!own) return fail(ErrorKind::usage, in_file(path.string(), own.error().message));
    presets.insert(presets.end(), own->begin(), own->end());
    return presets;
}

}  // namespace snug::cli
