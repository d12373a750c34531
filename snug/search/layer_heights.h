#pragma once

#include <vector>

#include "snug/search/arranged_items.h"

namespace snug {

/// Heights of so many layers, the highest first, that let each item lie in one of them: every choice that no
/// other makes needless, by what the ways of the items are high. `most`: blocks along x with walls and the
/// foam between layers; the lowest stacks first, at most some dozens. Where items have layers of their own
/// the one choice that is lowest, the lowest layer's height first.
[[nodiscard]] std::vector<std::vector<int>> layer_heights(const ItemMasks& masks, int layers,
                                                          const BlockWalls& walls, int most);

/// The heaviest layer at the bottom: which of the rooms is to lie how high, the lowest first. `mass`: of each
/// piece.
[[nodiscard]] std::vector<int> heaviest_first(const MaskLayout& layout, const std::vector<double>& mass,
                                              int layers);

}  // namespace snug
