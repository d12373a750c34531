#include <string_view>

#include "snug/design/presets.h"
#include "snug/design/project.h"
#include "snug/words/words.h"

#include "fuzz/check_mesh.h"

// Project files and users' presets: what is read is written and read again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view file(reinterpret_cast<const char*>(data), size);
    if (const auto project = snug::parse_project(file)) {
        const auto again = snug::parse_project(snug::project_json(*project));
        snug::fuzz::require(again && *again == *project);
    }
    const auto presets = snug::parse_presets(file);
    snug::fuzz::require(presets || !snug::text(presets.error().message).empty());
    return 0;
}
