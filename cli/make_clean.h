#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "snug/base/result.h"
#include "snug/design/clean_options.h"

namespace snug::cli {

/// The options of cleaning as they were typed; none where they were not.
struct CleanArguments {
    std::optional<std::string> drop, cut_plane;
    std::optional<double> drop_below;
};

void add_clean_options(CLI::App& command, CleanArguments& arguments);

/// Puts what was typed into the options. Fails with kind `usage`.
[[nodiscard]] Result<void> take_clean(const CleanArguments& arguments, CleanOptions& options);

}  // namespace snug::cli
