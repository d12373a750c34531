#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snug/polygon/row_triangulator.h"

// Rectangles left open in the faces of a solid, for whoever fills them.

namespace snug {

/// A rectangle left open in a face: strictly inside the face and apart from others. Level faces have rows
/// along y and positions along z; side faces have rows along the other horizontal axis and positions along x.
/// In steps (snug/polygon/lattice.h), of which each block counts a whole number along each axis.
struct FaceOpening {
    int axis = 0;   ///< across which the face lies: 0 level, 1 across y, 2 across z
    int plane = 0;  ///< the block line along that axis; level faces at 0 look down, others up
    int row_begin = 0, row_end = 0;
    int position_begin = 0, position_end = 0;
    /// Of its four vertices: at the beginning of both, at the end of its positions, of its rows, of both.
    std::uint32_t first_vertex = 0;
};

/// Passes the block line `first` before a row of blocks, `steps` wide, and every line within the row at which
/// an opening begins or ends. `corners` of the block line are used up.
void step_row(RowTriangulator& triangulator, int first, int steps, std::vector<LineCorner>& corners,
              std::span<const FaceRun> runs, std::span<const FaceOpening> openings);

}  // namespace snug
