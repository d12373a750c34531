#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace snug::bench {

/// Where public files lie: the folder that an environment variable names, or ../shared/NAME.
[[nodiscard]] inline std::filesystem::path shared_folder(const char* variable, const char* name) {
    const char* const own = std::getenv(variable);
    return own ? std::filesystem::path(own) : std::filesystem::path(SNUG_SOURCE_DIR "/../shared") / name;
}

/// Its files in order, those of an ending (".json") or all; none where it is absent.
[[nodiscard]] inline std::vector<std::filesystem::path> shared_files(const char* variable, const char* name,
                                                                     std::string_view ending = "") {
    const std::filesystem::path folder = shared_folder(variable, name);
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (ending.empty() || entry.path().extension() == ending) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace snug::bench
