#pragma once

#include <filesystem>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/cases.h"
#include "snug/words/words.h"

namespace snug::cli {

/// Where a user's own cases stand: cases.csv beside the user's presets.
[[nodiscard]] std::filesystem::path user_cases_path();

/// The built-in cases, then the user's own where the file exists. Lines that cannot be used are named on
/// standard error in the language, the others are used.
[[nodiscard]] Result<std::vector<KnownCase>> known_cases(Language language);

}  // namespace snug::cli
