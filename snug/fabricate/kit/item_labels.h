#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "snug/base/finding.h"
#include "snug/base/vec2.h"
#include "snug/foam/block_map.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

namespace snug {

/// What is written beside an item on the surface of the foam that it lies in, so that everybody lays it back.
struct ItemLabel {
    int layer = 1;        ///< of the item: the piece below it bears the label
    std::string words;    ///< its number and name, for a page
    std::string strokes;  ///< the same as far as stroke_text() has the letters, else the number alone
    Vec2d middle;         ///< z, y: mm from the corner at BACK and low z, seen from above
    double height_mm = 0;
    double foam_mm = 0;  ///< below it, where that is thinnest
};

/// The strokes of a label where it stands, as open lines: x along z, y along y, mm from the corner at BACK
/// and low z.
[[nodiscard]] std::vector<std::vector<Vec2d>> label_lines(const ItemLabel& label);

struct ItemLabels {
    std::vector<ItemLabel> labels;
    /// Where there is no room beside an item, `no_label`; where a name has letters that cannot be engraved,
    /// `label_letters` (notes).
    std::vector<Finding> findings;
};

/// A label for each item where the foam around it is flat at its parting level, as large as it can be (8 to 4
/// mm) at one of its sides, at least `away_mm` from all cavities. `layers`: what each layer cuts. `names`: of
/// the items, as people know them.
[[nodiscard]] ItemLabels item_labels(std::span<const Item> items, const std::vector<std::string>& names,
                                     std::span<const BlockMap> layers, const Foams& foams,
                                     const DesignSpace& space, double away_mm = 0);

}  // namespace snug
