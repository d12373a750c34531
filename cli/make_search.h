#pragma once

#include <optional>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/search_design.h"

#include "cli/console.h"

namespace snug::cli {

/// What is searched, and for how long.
struct SearchArguments {
    bool optimize = false, fit_case = false;
    std::optional<double> seconds;

    [[nodiscard]] bool asked() const { return optimize || fit_case; }
};

/// Searches from the design's placement and writes what was found into the design. Ctrl-C ends the search and
/// keeps the best so far.
[[nodiscard]] Result<SearchReport> search(Object& object, Design& design, const SearchArguments& arguments,
                                          StatusLine& status);

}  // namespace snug::cli
