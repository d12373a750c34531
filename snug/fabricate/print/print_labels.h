#pragma once

#include <span>
#include <string>
#include <vector>

#include "snug/base/grid.h"
#include "snug/base/run.h"
#include "snug/base/vec.h"
#include "snug/fabricate/kit/item_labels.h"
#include "snug/fabricate/printing/print_parts.h"
#include "snug/fabricate/printing/sunk_letters.h"

namespace snug {

struct PrintLabels {
    std::vector<std::vector<SunkLetters>> of_part;  ///< for each part of the layout, in its coordinates
    std::vector<std::string> cut;                   ///< words of labels that lie on no single part
    double volume_mm3 = 0;                          ///< of all letters
};

/// The labels that stand on a piece, as letters in the tops of the parts that it is printed as. `kept`: the
/// piece's blocks, from which the layout was made.
[[nodiscard]] PrintLabels print_labels(std::span<const ItemLabel> labels, const PrintLayout& layout,
                                       const Grid<Run>& kept, Vec3d block_mm);

}  // namespace snug
