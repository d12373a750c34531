#pragma once

#include <string_view>
#include <vector>

#include "snug/base/result.h"
#include "snug/mesh/mesh.h"

namespace snug {

/// Objects that Snug generates itself, in millimetres, the same bytes on every system.
///   torus      a ring with exactly 7,200 vertices (the paper's), closed
///   vase       a thick-walled turned vase with a neck, closed
///   camera     body, grip, lens, viewfinder and knobs as overlapping closed parts: a soup
///   figurine   a clay figure with limbs and undercuts, one closed surface
[[nodiscard]] std::vector<std::string_view> sample_names();

/// Fails (kind usage) for an unknown name; the sentence lists the known ones.
[[nodiscard]] Result<Mesh> sample(std::string_view name);

}  // namespace snug
