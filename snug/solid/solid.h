#pragma once

#include <vector>

#include "snug/base/grid.h"
#include "snug/base/vec.h"
#include "snug/foam/foam_pair.h"
#include "snug/space/design_space.h"

namespace snug {

/// One foam half as a closed surface in design coordinates, outward, without internal faces. Coplanar block
/// faces are merged: vertices stand only where the surface has a true corner, and none lies inside another
/// triangle's edge. Every edge belongs to exactly two triangles: where two columns meet in one edge only, its
/// vertices are doubled. An empty half has no triangles. Foams that a
/// leaning case shortens from their own side are built face by face (run_solid.h).
struct Solid {
    std::vector<Vec3f> vertices;
    std::vector<Triangle> triangles;
};

[[nodiscard]] Solid lower_solid(const FoamPair& foams, const DesignSpace& space);
[[nodiscard]] Solid upper_solid(const FoamPair& foams, const DesignSpace& space);

}  // namespace snug
