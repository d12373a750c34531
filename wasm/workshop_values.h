#pragma once

#include "snug/fabricate/kit/workshop_pack.h"
#include "snug/search/rank_cases.h"

#include "wasm/values.h"

namespace snug::wasm {

/// {files, documents: [{name, title, trueSize, pages}], containers: [{name, members}]}; the pages of a
/// document as drawing_json() has them.
[[nodiscard]] val to_val(const WorkshopPack& pack);
/// {figures: [{label, value}], findings}: what it takes.
[[nodiscard]] val figures_val(const WorkshopPack& pack);

/// {fitting: [...], nearest, leastInside}: `rotation_deg` lays the object into a case as it was ranked.
[[nodiscard]] val to_val(const CaseRanking& ranking, const Design& design);

}  // namespace snug::wasm
