#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/vec2.h"
#include "snug/check/item_lines.h"
#include "snug/check/packing.h"
#include "snug/check/pads.h"

namespace snug {

/// The foam between two things that lie one behind the other along an axis: items, or an item and the case.
struct PadContact {
    static constexpr int kCase = -1;
    int low = kCase, high = kCase;  ///< the item at either end, by its place in Packing::items
    Pads pads;
    /// The least way between the two where no foam lies between them, mm; infinite where some always does.
    double bare_mm = std::numeric_limits<double>::infinity();
    /// Where an item stands on islands (Packing::relief): the same as if the foam under them spread their
    /// load so well that it did not give way; none elsewhere. The truth lies between the two.
    std::optional<Pads> on_stiff_base = {};
};

/// The foam before a zone that may be pressed so much at most, towards one side.
struct ZonePads {
    std::size_t item = 0, zone = 0;  ///< of Packing::items, of its zones
    bool high = false;
    std::vector<PadColumn> columns;
};

/// All of them along an axis.
struct AxisContacts {
    int axis = 0;
    std::vector<PadContact> contacts;
    std::vector<std::vector<Vec2d>> outlines;  ///< of each item, the hull of it across the axis, mm
    std::vector<MassSpread> spreads;           ///< of each item
    std::vector<ZonePads> zones;
};

/// One column of foam between two such things.
struct ContactColumn {
    int low = PadContact::kCase, high = PadContact::kCase;
    std::int32_t row = 0, column = 0;  ///< of the lattice of the lines
    double from_mm = 0, to_mm = 0;     ///< where on the line the two end, design coordinates
    PadColumn pad;
};

/// What the foams of a packing hold every item with along the axis of the lines, each line a column of foam:
/// its thickness what foam stands on it between the two ends, its gap the rest of the way. Foam on a way to
/// the case that crosses the pocket of another item does not count, unless that item stands there: then it
/// lies between the two. What lies in a zone that foam keeps away from is not held. `pockets`: the blocks
/// that each item cuts. Blocks that the case has no room for are the case's own.
[[nodiscard]] AxisContacts pad_contacts(const AxisLines& lines, const Packing& packing,
                                        std::span<const BlockMap> pockets);

/// The columns that these contacts are the sums of, one by one, in the order of the lines.
[[nodiscard]] std::vector<ContactColumn> contact_columns(const AxisLines& lines, const Packing& packing,
                                                         std::span<const BlockMap> pockets);

}  // namespace snug
