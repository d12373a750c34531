#include "cli/user_foams.h"

#include "cli/files.h"
#include "cli/user_presets.h"

namespace snug::cli {

namespace fs = std::filesystem;

fs::path user_foams_path() {
    return user_presets_path().replace_filename("foams.json");
}

Result<std::vector<FoamMaterial>> known_foams() {
    std::vector<FoamMaterial> foams = built_in_foams();
    const auto own = read_own<FoamMaterial>(user_foams_path(), parse_foams);
    if (!own) return tl::unexpected(own.error());
    foams.insert(foams.end(), own->begin(), own->end());
    return foams;
}

}  // namespace snug::cli
