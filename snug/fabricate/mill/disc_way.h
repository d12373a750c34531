#pragma once

#include <optional>

#include "snug/fabricate/mill/mill_passes.h"

namespace snug {

/// What a disc that goes along the line covers of the line along x at this y: one stretch, since its way is
/// convex; none where it does not come there.
[[nodiscard]] std::optional<Stretch> stretch_of_way(const CutLine& line, double radius_mm, double y);

}  // namespace snug
