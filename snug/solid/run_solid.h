#pragma once

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/solid/solid.h"
#include "snug/space/design_space.h"

namespace snug {

/// As run_solid, with points in blocks from the first corner of the first block.
struct RunSurface {
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
};
[[nodiscard]] RunSurface run_surface(const Grid<Run>& runs);

/// The closed surface of one run of blocks in each column, for foams that a case shortens from both sides.
/// Outward, without internal faces, each block face two triangles. Every edge belongs to exactly two
/// triangles: where blocks meet in one edge or corner only, each has its own vertices there.
[[nodiscard]] Solid run_solid(const Grid<Run>& runs, const DesignSpace& space);

}  // namespace snug
