#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/search_design.h"

#include "cli/console.h"

namespace snug::cli {

/// The options of the search as they were typed.
struct SearchArguments {
    bool optimize = false, fit_case = false, billed_weight = false;
    std::optional<std::string> objective, upright, seed;
    std::optional<double> seconds;

    [[nodiscard]] bool asked() const { return optimize || fit_case; }
};

void add_search_options(CLI::App& make, SearchArguments& arguments);

/// Applies what was typed to the design. Fails with kind `usage`.
[[nodiscard]] Result<void> apply(const SearchArguments& arguments, SearchOptions& search);

/// Searches from the design's placement and writes what was found into the design. Ctrl-C ends the search and
/// keeps the best so far.
[[nodiscard]] Result<SearchReport> search(Object& object, Design& design, const SearchArguments& arguments,
                                          StatusLine& status);

}  // namespace snug::cli
