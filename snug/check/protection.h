#pragma once

#include <span>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/check/packing.h"
#include "snug/check/protection_report.h"
#include "snug/design/design.h"
#include "snug/object/object.h"

namespace snug {

/// Whether the design says anything that this could tell of.
[[nodiscard]] bool wants_protection(const Design& design);

/// Where the mass of an item is centred, by its own choice, the design's, or taken to be of one density. mm,
/// design coordinates.
[[nodiscard]] Vec3d mass_centre(const Object& object, const Item& item, const ItemOptions& own,
                                const Design& design);

/// Of a packing with foams. What must be known is added to its findings. Fails only when cancelled.
[[nodiscard]] Result<Protection> protection(std::span<const Object> objects, Packing& packing,
                                            const Design& design, const Progress& progress = {});

}  // namespace snug
