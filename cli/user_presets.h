#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/presets.h"
#include "snug/words/words.h"

#include "cli/files.h"

namespace snug::cli {

/// Where a user's own presets stand: $XDG_CONFIG_HOME/snug/presets.json, else ~/.config/snug/presets.json.
[[nodiscard]] std::filesystem::path user_presets_path();

/// The built-in presets, then the user's own where the file exists.
[[nodiscard]] Result<std::vector<Preset>> known_presets();

/// What `parse` makes of a file of the user's own; nothing where there is none. Errors name the file.
template <class Known>
[[nodiscard]] Result<std::vector<Known>> read_own(const std::filesystem::path& path,
                                                  Result<std::vector<Known>> (*parse)(std::string_view)) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return std::vector<Known>();
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto own = parse({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (!own) return fail(ErrorKind::usage, in_file(path.string(), own.error().message));
    return own;
}

}  // namespace snug::cli
