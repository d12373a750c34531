#pragma once

#include <span>

#include "snug/fabricate/mould/bored_faces.h"
#include "snug/fabricate/mould/draft_slabs.h"
#include "snug/solid/step_solid.h"

namespace snug {

/// The closed surface of slabs that stand on each other, top first: every edge belongs to exactly two
/// triangles, none is flat, and vertices stand only where the surface has a corner or another face's edge
/// ends. Its base is the last slab's bottom. The slabs' regions nowhere meet themselves in mere points, see
/// draft_slabs(), and the slabs lean alike. Bores open in the box's upright sides, in the top and in the
/// base.
[[nodiscard]] StepSolid slab_solid(std::span<const DraftSlab> slabs, const PlanBox& box,
                                   std::span<const SlabBore> bores = {});

}  // namespace snug
