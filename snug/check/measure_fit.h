#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/bearing.h"
#include "snug/check/gap.h"
#include "snug/check/packing.h"
#include "snug/design/design.h"
#include "snug/object/object.h"

namespace snug {

/// How well a packing's foams hold the object: sampled, and slower than the packing itself.
struct MeasuredFit {
    std::optional<GapFigures> gap;             ///< how far the cut space exceeds the objects
    std::vector<GapReport> layer_gaps;         ///< of each layer; empty where it is not known
    std::optional<BearingReport> bearing;      ///< what all items lie on in either half
    std::vector<BearingReport> item_bearings;  ///< of each item; empty where it is not known
};

/// Of a packing with foams, to whose findings is added what comes out; nothing is known where an object
/// is no whole mesh. Fails only when cancelled.
[[nodiscard]] Result<MeasuredFit> measure_fit(std::span<const Object> objects, Packing& packing,
                                              const Design& design, const Progress& progress = {});

}  // namespace snug
