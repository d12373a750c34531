#pragma once

#include <string>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/words/words.h"

#include "cli/pdf.h"

// The workshop's part of `snug make`: what is shown before anything is written, its files.

namespace snug::cli {

/// Where the files of packs lie within a run's folder: for each way of working its name.
[[nodiscard]] std::vector<std::string> workshop_folders();

/// The figures as lines under a heading.
[[nodiscard]] std::string workshop_summary(const WorkshopPack& pack, const Design& design, Language language);

struct WorkshopFiles {
    std::vector<PackFile> files;
    std::vector<Finding> findings;  ///< that a page lacks letters of a name
};

/// Every file of the pack, drawings as PDF and containers zipped.
[[nodiscard]] Result<WorkshopFiles> workshop_files(const WorkshopPack& pack, const PdfLetters& letters);

}  // namespace snug::cli
