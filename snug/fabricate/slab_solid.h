#pragma once

#include <array>
#include <span>
#include <vector>

#include "snug/base/vec.h"
#include "snug/fabricate/draft_slabs.h"

namespace snug {

/// A solid in steps: x counts the height, y and z lie in plan.
struct StepSolid {
    std::vector<Vec3i> points;
    std::vector<Triangle> triangles;  ///< outward where x, y and z are right-handed

    [[nodiscard]] bool empty() const { return triangles.empty(); }
};

/// A blind bore into a face that stands upright on the box's sides (axis 1 or 2), or into the top (axis 0) or
/// the base. Its mouth lies within that face.
struct SlabBore {
    int axis = 0;
    bool low = false;        ///< into the face at the box's least y or z, or into the base
    int depth = 0;           ///< steps, into the solid
    std::vector<Vec3i> rim;  ///< the mouth's corners, in either direction round
};

/// The closed surface of slabs that stand on each other, top first: every edge belongs to exactly two
/// triangles, none is flat, and vertices stand only where the surface has a corner or another face's edge
/// ends. Its floor is the last slab's bottom. The slabs' regions nowhere meet themselves in mere points, see
/// draft_slabs().
[[nodiscard]] StepSolid slab_solid(std::span<const DraftSlab> slabs, const PlanBox& box,
                                   std::span<const SlabBore> bores = {});

/// In steps cubed.
[[nodiscard]] double volume_of(const StepSolid& solid);

}  // namespace snug
