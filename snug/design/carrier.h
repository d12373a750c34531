#pragma once

#include <string_view>

#include "snug/design/design.h"

namespace snug {

/// Who moves the case, which says from how high it may fall.
enum class Carrier {
    store,    ///< it stays where it is kept: nothing is claimed about drops
    hand,     ///< carried by hand: 760 mm
    courier,  ///< by somebody who carries such things: as a parcel, since nobody sees to it all the way
    parcel,   ///< through the post: ISTA 2A, by the packed mass
};
template <>
struct Names<Carrier> {
    static constexpr std::string_view list[] = {"store", "hand", "courier", "parcel"};
};

/// The drop that goes with it, unless the design says another or is a tray's (docs/protection.md).
void expect_drops(Carrier carrier, Design& design);

/// The foam that is usual around things, mm, where nothing is known of what they meet: enough of a cushion on
/// the way, less in a store.
[[nodiscard]] double usual_wall_mm(Carrier carrier);

/// What its preset brings, or that of its way of working, where that does not cushion; else the above.
[[nodiscard]] double usual_wall_mm(const Design& design, Carrier carrier);

}  // namespace snug
