#pragma once

#include <vector>

#include "snug/base/grid.h"
#include "snug/base/half.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"

namespace snug {

/// A piece of foam as a closed surface in design coordinates, outward, without internal faces. Coplanar block
/// faces are merged: vertices stand only where the surface has a true corner, and none lies inside another
/// triangle's edge. Every edge belongs to exactly two triangles: where blocks meet in one edge or corner
/// only, vertices are doubled (corner_fans.h). An empty piece has no triangles.
struct Solid {
    std::vector<Vec3f> vertices;
    std::vector<Triangle> triangles;
};

/// `runs`: the blocks in each column, counted from the half's own side.
[[nodiscard]] Solid solid_of(const Grid<Run>& runs, const DesignSpace& space, Half half);

[[nodiscard]] Solid solid_of(const Foams& foams, Piece piece, const DesignSpace& space);
[[nodiscard]] Solid lower_solid(const Foams& foams, const DesignSpace& space);
[[nodiscard]] Solid upper_solid(const Foams& foams, const DesignSpace& space);

}  // namespace snug
