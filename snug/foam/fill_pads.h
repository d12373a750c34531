#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "snug/base/box.h"
#include "snug/base/piece.h"
#include "snug/depth/object_depths.h"
#include "snug/design/fit_options.h"
#include "snug/foam/foams.h"
#include "snug/space/design_space.h"
#include "snug/space/item.h"

// Foam ends in whole blocks, so that between it and an item up to a block's height stays free in most
// columns. Pads of sheet foam fill that: rectangles over columns, as thick as the narrowest place under them
// allows, stacked from sheets of one thickness.

namespace snug {

/// A pad that lies on the foam below an item, or hangs under the foam above it.
struct FillPad {
    std::size_t item = 0;
    Piece piece;                                         ///< that it lies on, or hangs under
    bool above = false;                                  ///< the item
    int first_j = 0, end_j = 0, first_k = 0, end_k = 0;  ///< columns that it spans
    int sheets = 0;                                      ///< that it is stacked from
    double thickness_mm = 0;
    Box3d box;  ///< design coordinates
};

struct FillPads {
    std::vector<FillPad> pads;  ///< item by item, those below it first, of these the largest first
    long long left_out = 0;     ///< that an item would have beside its kMostPads
    double squeeze_mm = 0;      ///< how far those above an item reach into it
};

constexpr std::size_t kMostPads = 24;    ///< below and above an item each
constexpr double kLeastPadSide = 20;     ///< mm
constexpr double kLeastPad = 3;          ///< mm thick
constexpr double kMostLeftAbovePad = 2;  ///< mm between the nearest place of an item and a pad above it

/// The pads of every item, at most kMostPads on either side of it, the largest volume first. One below leaves
/// the item its clearance, so that what lies on foam goes on lying on it; one above comes as near as its
/// sheets allow, within 2 mm, or `squeeze_mm` into it where that is asked for. No pad lies where any zone of
/// an item is seen, where other than that item's own blocks are cut away, or where nothing carries it.
/// `depths`: what each item sees. Fails as object_depths() does.
[[nodiscard]] Result<FillPads> fill_pads(const std::vector<Item>& items,
                                         std::span<const std::shared_ptr<const ObjectDepths>> depths,
                                         const Foams& foams, const DesignSpace& space,
                                         const PadOptions& options);

}  // namespace snug
