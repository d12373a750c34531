#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/words/words.h"

#include "cli/make_tools.h"

// The workshop's part of `snug make`: its options, what is shown before anything is written, its files.

namespace snug::cli {

/// As they were typed; none where they were not.
struct WorkshopArguments {
    std::optional<std::string> work, paper, price, stock, bed;
    std::optional<double> mass, sheet, kerf, dowel;
    ToolArguments tools;
    bool dry_run = false;
};

void add_workshop_options(CLI::App& make, WorkshopArguments& arguments);

/// What else of the command line decides whether --for chooses the foam.
struct FoamChoice {
    bool preset_named = false;
    bool from_project = false;  ///< a project has its foam already
};

/// The name of the preset that --for implies here; none where the foam was chosen otherwise. Errors as
/// apply_workshop() gives them.
[[nodiscard]] Result<std::optional<std::string>> implied_preset(const WorkshopArguments& arguments,
                                                                const FoamChoice& choice);

/// Applies what was typed. Errors are of kind `usage` and name the option.
[[nodiscard]] Result<void> apply_workshop(const WorkshopArguments& arguments, Design& design);

/// Where the files of packs lie within a run's folder: for each way of working its name.
[[nodiscard]] std::vector<std::string> workshop_folders();

/// The figures as lines under a heading.
[[nodiscard]] std::string workshop_summary(const WorkshopPack& pack, const Design& design, Language language);

/// Every file of the pack, drawings as PDF and containers zipped.
[[nodiscard]] Result<std::vector<PackFile>> workshop_files(const WorkshopPack& pack);

}  // namespace snug::cli
