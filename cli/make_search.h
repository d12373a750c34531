#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/arrange.h"
#include "snug/search/search_design.h"

#include "cli/console.h"

namespace snug::cli {

/// What is searched, and for how long.
struct SearchArguments {
    bool optimize = false, fit_case = false;
    bool arrange = false, no_arrange = false, known_case = false;
    std::optional<double> seconds;

    /// Of one item the best placement and case; of several where each lies.
    [[nodiscard]] bool searches(const Design& design) const;
    /// By itself only items that are `typed`: a project gives what it gave before.
    [[nodiscard]] bool arranges(const Design& design, bool typed) const;
};

/// Searches from the design's placement and writes what was found into the design. Ctrl-C ends the search and
/// keeps the best so far.
[[nodiscard]] Result<SearchReport> search(Object& object, Design& design, const SearchArguments& arguments,
                                          StatusLine& status);

/// Arranges the items of the design, and writes where they lie into it. `cases`: of which the smallest that
/// holds them is taken, where that is asked for. Ctrl-C as above, once all of them go in.
[[nodiscard]] Result<Arrangement> arrange(std::span<Object> objects, Design& design,
                                          const SearchArguments& arguments,
                                          const std::vector<KnownCase>& cases, StatusLine& status);

}  // namespace snug::cli
