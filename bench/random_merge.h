#pragma once

#include <cstdint>
#include <vector>

#include "snug/base/grid.h"
#include "snug/fabricate/bricks/brick_build.h"

namespace snug::bench {

/// Layers of bricks in each cell of studs, seen cavity up.
using BrickHeights = Grid<std::uint16_t>;

/// What is built with: sizes in studs, width <= length.
struct MergeOptions {
    BrickKind kind = BrickKind::brick;  ///< of every piece
    std::vector<BrickSize> family;      ///< with 1x1 among them
    std::uint64_t seed = 1;
};

/// The bricks of Luo et al.'s paper: 1 x 1, 2, 3, 4, 6, 8 and 2 x 2, 3, 4, 6, 8.
[[nodiscard]] std::vector<BrickSize> luo_family();

/// The initial layout of Luo et al., "Legolization: Optimizing LEGO Designs" (SIGGRAPH Asia 2015, section 5):
/// a 1x1 brick in each cell of each layer, random pairs of neighbours merged until no pair is left whose
/// union is in the family; then, while there is more than one connected piece, bricks around one that
/// touches other pieces are taken apart and merged anew, within a ring that grows by one every 10 failures,
/// until 100 failures in a row. Layer by layer from the floor, in a layer from the far left. The same for
/// the same seed.
[[nodiscard]] BrickBuild random_merge(const BrickHeights& heights, const MergeOptions& options);

}  // namespace snug::bench
