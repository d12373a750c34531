#pragma once

#include <algorithm>
#include <limits>

#include "snug/base/grid.h"
#include "snug/mesh/mesh.h"
#include "snug/object/prepared_surface.h"
#include "snug/space/design_space.h"
#include "snug/space/placement.h"

namespace snug {

/// How far the object is grown before it is compared with cells and blocks, on both sides along each axis,
/// in mm; may be negative. One rule for all three axes, so that a face which merely coincides with a block's
/// face cuts nothing.
struct Reach {
    Vec3d mm;
};

/// The clearance less 0.01 mm; with `cut_on_touch` the clearance itself, so that touching counts (the paper's
/// literal "overlap or touch", section 3.2). Both with a billionth of a millimetre on top: coordinates that
/// should tie but are rounded apart count as touching.
[[nodiscard]] Reach reach(Vec3d clearance_mm, bool cut_on_touch);
[[nodiscard]] inline Reach reach(double clearance_mm, bool cut_on_touch) {
    return reach(Vec3d{clearance_mm, clearance_mm, clearance_mm}, cut_on_touch);
}

/// The lowest and highest x of the object's surface within one column; none where lowest > highest.
struct DepthRange {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool none() const { return lowest > highest; }
    void include(double x) {
        lowest = std::min(lowest, x);
        highest = std::max(highest, x);
    }
    void include(DepthRange other) {
        lowest = std::min(lowest, other.lowest);
        highest = std::max(highest, other.highest);
    }
};

/// The paper's depth textures A and B (section 3.2), exact instead of sampled: for each column the extremes
/// of x over all points of the surface whose y and z lie in the column's cell grown by `reach`, bounds
/// included.
using DepthMap = Grid<DepthRange>;
[[nodiscard]] DepthMap depth_map(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                                 Reach reach);
/// The same of a surface and one more, whose depth map for the same space and reach is known.
[[nodiscard]] DepthMap depth_map(const Mesh& mesh, const Placement& placement, const DesignSpace& space,
                                 Reach reach, DepthMap known);
/// The same to the bit, without looking at most of the surface.
[[nodiscard]] DepthMap depth_map(const PreparedSurface& surface, const Placement& placement,
                                 const DesignSpace& space, Reach reach);

}  // namespace snug
