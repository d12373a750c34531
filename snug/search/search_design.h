#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/mesh/mesh.h"
#include "snug/object/prepared_surface.h"

namespace snug {

/// What a search did, as report.json has it.
struct SearchReport {
    std::string method;  ///< "fit-case", "placement" or "fit-case, placement"
    long long evaluations = 0;
    std::optional<long long> start_cut_blocks;  ///< none where the object did not fit as it stood
    long long cut_blocks = 0;
    std::uint32_t seed = 0;
    bool cancelled = false;  ///< what is here is the best until then
};

/// What to search, and for how long.
struct SearchTask {
    bool fit_case = false;   ///< choose the block counts first
    bool placement = false;  ///< then turn and shift inside them
    long long evaluations = 0;
};

/// Is told the share of the evaluations that is done and the blocks cut so far, if known; false cancels.
using SearchNews = std::function<bool(double share, std::optional<long long> cut_blocks)>;

/// Searches from the design's placement and writes what was found into it: block counts, rotation, offset.
/// Counts that were to be fitted become those of the start. Fails (kind does_not_fit) where the object fits
/// in no orientation, with the sentence of fitting_rotation(), or as fit_case() does.
[[nodiscard]] Result<SearchReport> search_design(const Mesh& mesh, const PreparedSurface& surface,
                                                 Design& design, const SearchTask& task,
                                                 const SearchNews& news = {});

}  // namespace snug
