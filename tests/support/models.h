#pragma once

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snug::test {

/// The bytes of one of the shared real objects, which the repository does not hold; none where they are
/// absent. They are looked for in $SNUG_MODELS, else beside the repository.
[[nodiscard]] inline std::optional<std::vector<std::byte>> model_file(std::string_view name) {
    const char* folder = std::getenv("SNUG_MODELS");
    const std::string path =
        (folder ? std::string(folder) : std::string(SNUG_SOURCE_DIR "/../shared/models")) + "/" +
        std::string(name);
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) return {};
    std::vector<std::byte> bytes(static_cast<std::size_t>(file.tellg()));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return bytes;
}

}  // namespace snug::test
