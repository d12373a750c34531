#pragma once

#include <optional>
#include <span>
#include <vector>

#include "snug/check/flat_drop.h"
#include "snug/check/pad_contacts.h"
#include "snug/design/stress_curve.h"

namespace snug {

/// Items that reach one another through foam along an axis, and the foam between them and the case. What one
/// of them meets depends on all: of two equal masses on equal springs separate balances would give the lower
/// 45 G where 34 are right.
struct JointItems {
    std::vector<int> items;  ///< their places in Packing::items
    std::vector<double> mass_kg;
    std::vector<const PadContact*> contacts;  ///< between these and the case alone
    bool to_high = false;                     ///< they fall to the high side of the axis, else to the low one
};

/// What they meet, item by item.
struct JointStops {
    /// What each met at its worst, where its foam ahead (of the case or of another item) was then; none where
    /// something bottomed, so that it is not known.
    std::vector<std::optional<Stop>> stops;
    std::vector<bool> bottoms;  ///< on which foam bottomed, or something met something
    bool items_meet = false;    ///< two of them, through foam or none
    bool unsettled = false;     ///< they did not turn round in the steps that are allowed: nothing is known
};

/// The case falls from `height_mm` and stops at once; then all masses move along the axis, integrated in
/// steps of equal time, 40,000 at most. Contacts push and never pull, and give back what they took, until
/// every item has turned round.
[[nodiscard]] JointStops joint_drop(const JointItems& items, const StressCurve& curve, double height_mm,
                                    double thin_mm);

/// At rest: each carries all that lies above it.
[[nodiscard]] JointStops joint_rest(const JointItems& items, const StressCurve& curve);

/// The items of an axis that reach one another, and those alone: each set of them by its places, lowest
/// first.
[[nodiscard]] std::vector<std::vector<int>> joint_sets(std::span<const PadContact> contacts,
                                                       std::size_t item_count);

}  // namespace snug
