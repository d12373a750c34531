#pragma once

#include "snug/fabricate/bricks/brick_layout.h"
#include "snug/fabricate/bricks/laid_bricks.h"

namespace snug {

/// Lays neighbourhoods of seams between pieces again until all is one piece, or until many tries in a row
/// gain nothing (Luo et al. 2015, section 4.2; but a brick is put across the seam first). Gives the number of
/// pieces that are left. The same for the same bricks.
int join_pieces(const std::vector<BrickCourse>& courses, LaidBricks& laid, BrickBox& box);

}  // namespace snug
