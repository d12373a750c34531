#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "snug/base/progress.h"
#include "snug/base/result.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/item_ways.h"
#include "snug/search/mask_packer.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// From items to masks to be packed, and from where the masks lie back to items.

namespace snug {

/// Walls in whole blocks on each side, and the gap between items.
struct BlockWalls {
    std::array<int, 6> side{};
    MaskGap gap;
    int between_layers = 0;
    [[nodiscard]] int along(int axis) const {
        return side[static_cast<std::size_t>(2 * axis)] + side[static_cast<std::size_t>(2 * axis) + 1];
    }
};
[[nodiscard]] BlockWalls block_walls(const SpaceOptions& space, Vec3d block_mm);

/// Blocks along x that layers of such heights take with walls and the foam between them.
[[nodiscard]] int height_of_layers(const std::vector<int>& heights, const BlockWalls& walls);

/// All items of a design as masks. Shape i of the problem is way i.
struct ItemMasks {
    MaskProblem problem;
    std::vector<ItemWay> ways;
    std::vector<Item> items;  ///< as place_items() lays them first, for their names and masses
    std::vector<std::vector<ItemZone>> zones;  ///< of each item, as searched_zones() has them
    std::vector<bool> locked;                  ///< of each item
    std::vector<double> mass;  ///< of each item in kg or, where one is not known, in blocks that are cut
    Vec3d block_mm;
    [[nodiscard]] bool any_locked() const;
};

/// The ways of every item that is not locked. `objects` are prepared for many. Fails as place_items() does,
/// and with kind `usage` where an item cuts nothing, so that nothing says where it may lie.
[[nodiscard]] Result<ItemMasks> item_masks(std::span<const Object> objects, const Design& design,
                                           Vec3d block_mm, const std::vector<bool>& locked,
                                           const Progress& progress = {});

/// The same where locked items lie in a space whose walls are so many blocks: their shapes and places are put
/// into the problem. Fails with kind `usage` where two of them meet or one leaves the space.
[[nodiscard]] Result<ItemMasks> with_locked(ItemMasks masks, std::span<const Object> objects,
                                            const DesignSpace& space, const BlockWalls& walls);

/// Where a layer of items begins, and how many blocks high it is.
struct LayerLevels {
    int first = 0, height = 0;
    std::optional<int> parting;  ///< where its foams are to part; none: in its middle
    /// The first level that an item so high cuts: its middle where the foams part, as near as the layer lets.
    [[nodiscard]] int first_of(int item_height) const;
};
/// The lowest layer first, from the floor's wall upward.
[[nodiscard]] std::vector<LayerLevels> layer_levels(const std::vector<int>& heights, const BlockWalls& walls);

/// Writes where the items lie into the design: rotation, offset and layer of each that is not locked. In a
/// tray offsets have no x. `levels`: of each room of the layout, the lowest layer's first.
void take_layout(const ItemMasks& masks, const MaskLayout& layout, const std::vector<LayerLevels>& levels,
                 const DesignSpace& space, const BlockWalls& walls, Design& design);

}  // namespace snug
