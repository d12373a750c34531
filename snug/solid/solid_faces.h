#pragma once

#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/solid/face_openings.h"
#include "snug/solid/solid_corners.h"

// The faces of a solid of blocks as triangles, plane by plane, optionally with rectangles left open in them.

namespace snug {

/// Appends every face of the solid with these runs and corners, outward where x counts the levels. Vertices
/// are those of the corners and of the openings. `block_steps`: how many steps of the openings' lattice a
/// block counts along x, y and z.
void add_faces(const Grid<Run>& runs, const SolidCorners& corners, std::span<const FaceOpening> openings,
               Vec3i block_steps, std::vector<Triangle>& triangles);
/// The same without openings.
void add_faces(const Grid<Run>& runs, const SolidCorners& corners, std::vector<Triangle>& triangles);

}  // namespace snug
