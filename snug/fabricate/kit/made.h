#pragma once

#include <optional>

#include "snug/check/measure_fit.h"
#include "snug/check/packing.h"
#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/search/arrange.h"
#include "snug/search/search_design.h"
#include "snug/words/words.h"

namespace snug {

/// Everything that was made of an object and a design, and found out about it.
struct Made {
    std::optional<SearchReport> search;      ///< none where nothing was searched
    std::optional<Arrangement> arrangement;  ///< none where nothing was arranged
    bool walls_chosen = false;               ///< after that, for what the items bear
    Packing packing;                         ///< without foams where the object leaves its space
    MeasuredFit fit;
    std::optional<Protection> protection;   ///< none where the design does not ask for it
    std::optional<WorkshopPack> pack;       ///< none where the design asks for none
    Language language = Language::english;  ///< in which its pack is, and its report and preview shall be
};

}  // namespace snug
