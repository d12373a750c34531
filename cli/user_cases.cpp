#include "cli/user_cases.h"

#include "cli/console.h"
#include "cli/files.h"
#include "cli/user_presets.h"

namespace snug::cli {

namespace fs = std::filesystem;

fs::path user_cases_path() {
    return user_presets_path().replace_filename("cases.csv");
}

Result<std::vector<KnownCase>> known_cases(Language language) {
    std::vector<KnownCase> cases = built_in_cases();
    const fs::path path = user_cases_path();
    std::error_code error;
    if (!fs::exists(path, error)) return cases;
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const CaseList own = parse_cases({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    for (const Message& problem : own.problems)
        (void)report(
            {ErrorKind::input, say("cases.other_lines", {{"file", path.string()}, {"problem", problem}})},
            language);
    cases.insert(cases.end(), own.cases.begin(), own.cases.end());
    return cases;
}

}  // namespace snug::cli
