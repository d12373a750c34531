#pragma once

#include <filesystem>
#include <vector>

namespace snug::cli {

/// TrueType fonts of this machine for letters that PDF's built-in fonts lack, those for Japanese first
/// (`apt install fonts-ipafont-gothic` brings one). Looked for in the usual folders of systems and users.
[[nodiscard]] std::vector<std::filesystem::path> fonts_beyond_latin();

}  // namespace snug::cli
