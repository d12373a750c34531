#pragma once

#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/words/words.h"

// The workshop's part of `snug make`: what is shown before anything is written, its files.

namespace snug::cli {

/// Where the files of packs lie within a run's folder: for each way of working its name.
[[nodiscard]] std::vector<std::string> workshop_folders();

/// The figures as lines under a heading.
[[nodiscard]] std::string workshop_summary(const WorkshopPack& pack, const Design& design, Language language);

/// Every file of the pack, drawings as PDF and containers zipped.
[[nodiscard]] Result<std::vector<PackFile>> workshop_files(const WorkshopPack& pack);

}  // namespace snug::cli
