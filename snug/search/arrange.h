#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "snug/base/result.h"
#include "snug/design/cases.h"
#include "snug/design/design.h"
#include "snug/object/object.h"
#include "snug/search/shock_wishes.h"

// The smallest case that holds several items: how each is turned, where it lies and in which layer. On masks
// of the columns that the items cut (item_ways.h, mask_rooms.h), so what the method makes of the design
// afterwards is exactly this.

namespace snug {

/// What an arrangement found, as report.json has it.
struct Arrangement {
    std::uint32_t seed = 0;
    long long work = 0;     ///< places of one item that were looked at
    double volume_mm3 = 0;  ///< of all blocks
    /// No arrangement of these items with these turns needs less, where it keeps such walls as were kept;
    /// none where some are locked, for a tray, and in a space that is given.
    std::optional<double> lower_bound_mm3;
    long long cut_blocks = 0;  ///< by the items alone
    bool cancelled = false;    ///< what is here is the best until then
    double ms = 0;             ///< that it took
};

/// Whom it tells.
struct ArrangeWatch {
    /// The share of the work that is done, and the volume of the best so far; false cancels.
    std::function<bool(double share, std::optional<double> volume_mm3)> go_on;
    /// Every better answer, as the design would then be.
    std::function<void(const Design&)> better = {};
    /// Packs the objects by a design; only needed where shocks are weighed.
    PackIt pack_it = {};
};

/// What is usually enough: some tenths of a second for each item, on one core.
[[nodiscard]] long long usual_arranging_work(const Design& design);

/// Arranges all items that are not locked and writes where they lie into the design: in its case or its
/// blocks, or, where it leaves their number open, in the fewest, which it then has. The walls that the design
/// wants are kept, and `between` among the items; in a space that is given without any, walls of 50, 25.4 or
/// 12.7 mm where they leave room, and layers lie in its middle. Of equal volumes the one that cuts less is
/// taken, and of these one whose weight lies nearer to the middle; of several layers the heaviest lies
/// lowest. Where shocks are weighed a few arrangements in that volume are compared by what the items meet on
/// their worst side, by the full calculation, and the least is taken. `all`: also items that have a place
/// already. Objects are prepared for many here. The same for the same seed on every machine and any number of
/// threads, unless cancelled. Fails with kind `does_not_fit` where the space does not hold them all, as far
/// as was looked (the sentence says which are left, and what would hold them), and with kind `usage` where
/// locked items meet or there are more layers than items.
[[nodiscard]] Result<Arrangement> arrange(std::span<Object> objects, Design& design, bool all, long long work,
                                          const ArrangeWatch& watch = {});

/// The same in the smallest of the known cases that holds them (by volume or billed weight, as the design's
/// search says), which the design then has; with the walls of a space that is fitted to its
/// items. Fails with kind `does_not_fit` where none does.
[[nodiscard]] Result<Arrangement> arrange_in_known_case(std::span<Object> objects, Design& design, bool all,
                                                        const std::vector<KnownCase>& known, long long work,
                                                        const ArrangeWatch& watch = {});

}  // namespace snug
