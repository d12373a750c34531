#pragma once

#include <filesystem>
#include <optional>

#include "snug/base/result.h"
#include "snug/design/project.h"
#include "snug/pipeline.h"
#include "snug/search/search_design.h"

#include "cli/console.h"
#include "cli/make_search.h"

namespace snug::cli {

/// What is to be made, and from which file.
struct Task {
    std::filesystem::path object_path;
    Project project;
    /// A project's object as it was when the project was made; none for an object alone.
    std::optional<ObjectFile> expected;
    bool units_typed = false;    ///< on this command line, not in the project
    std::optional<bool> stream;  ///< whether to read in pieces; none: where the file is large
};

struct Packed {
    Object object;
    Packing packing;
    std::optional<SearchReport> search;
};

/// Reads, measures, searches and packs; fills in the project's object and, after a search, its placement;
/// adds what only the file knows to the findings. Errors name the file.
[[nodiscard]] Result<Packed> read_and_pack(Task& task, const SearchArguments& search, StatusLine& status);

}  // namespace snug::cli
