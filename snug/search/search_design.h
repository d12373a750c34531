#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/shock_wishes.h"

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
    PackIt pack_it = {};  ///< packs the object; only needed where shocks are weighed
};

/// Is told the share of the evaluations that is done and the blocks cut so far, if known; false cancels.
using SearchNews = std::function<bool(double share, std::optional<long long> cut_blocks)>;

/// Searches from the design's placement and writes what was found into it: block counts, rotation, offset.
/// Counts that were to be fitted become those of the start. The object is the design's only item, with its
/// mesh or stand-in, and prepared for many (prepare.h). Fails (kind does_not_fit) where it fits in no
/// orientation, with the sentence of fitting_rotation(), or as fit_case(), zone_surface() and, where shocks
/// are weighed, lacking_for_search() do.
[[nodiscard]] Result<SearchReport> search_design(const Object& object, Design& design, const SearchTask& task,
                                                 const SearchNews& news = {});

}  // namespace snug
