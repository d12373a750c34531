#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "snug/base/result.h"

namespace snug::cli {

/// What the local server answers with, by address ("/index.html"). Nothing else exists for it: no folder is
/// looked into while it runs, so no address can lead out of one.
struct Site {
    std::map<std::string, std::filesystem::path> files;      ///< read anew for each answer
    std::map<std::string, std::vector<std::byte>> contents;  ///< kept in memory
};

/// Every regular file below a folder, hidden files and links left out; "/" is its index.html. Fails (input)
/// where there is none.
[[nodiscard]] Result<Site> site_of_folder(const std::filesystem::path& folder);

/// Serves on 127.0.0.1 alone until Ctrl-C, which is a good end. `port` 0: the first free one from the usual
/// on. `on_ready` hears the port. Fails (output) where the port cannot be had.
[[nodiscard]] Result<void> serve(const Site& site, int port, const std::function<void(int)>& on_ready);

}  // namespace snug::cli
