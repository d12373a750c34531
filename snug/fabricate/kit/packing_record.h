#pragma once

#include <cstddef>
#include <optional>

#include "snug/drawing/page_builder.h"

namespace snug {

/// What a packing sheet leaves to be filled in by hand.
struct PackingRecord {
    std::size_t items = 1;             ///< to be counted
    std::optional<double> content_kg;  ///< of items and foam; none where either is not known
    bool fragile = false;              ///< a drop was asked for: the case is marked so
};

/// Lines for who packed and unpacked it when, how many items there were and in what condition, the gross
/// mass, parts taken off, batteries and liquids, spare foam; and the marks that show which way is up.
void draw_packing_record(PageFlow& flow, const PackingRecord& record);

}  // namespace snug
