#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/base/grid.h"
#include "snug/polygon/corners.h"
#include "snug/polygon/triangulate.h"

// The faces of a height field as triangles, plane by plane, optionally with rectangles left open in them.

namespace snug {

/// Places within a block: block lines stand at multiples of this in a plane's own coordinates.
constexpr int kBlockSteps = 4096;

/// A rectangle left open in a face, for whoever fills it: strictly inside the face and apart from others.
/// Level faces have rows along y and positions along z; side faces have rows along the other horizontal axis
/// and positions along x. In steps of a block, as kBlockSteps says.
struct FaceOpening {
    int axis = 0;   ///< across which the face lies: 0 level, 1 across y, 2 across z
    int plane = 0;  ///< the block line along that axis; level faces at 0 are the base
    int row_begin = 0, row_end = 0;
    int position_begin = 0, position_end = 0;
    /// Of its four vertices: at the beginning of both, at the end of its positions, of its rows, of both.
    std::uint32_t first_vertex = 0;
};

/// Appends every face of the solid that the heights bound, outward where x counts the levels.
void add_faces(const Grid<std::uint16_t>& heights, const SolidCorners& corners,
               std::span<const FaceOpening> openings, std::vector<Triangle>& triangles);

}  // namespace snug
