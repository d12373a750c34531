#pragma once

#include <optional>
#include <vector>

#include "snug/fabricate/mill/mill.h"
#include "snug/fabricate/mill/mill_path.h"

namespace snug {

/// One stock and what is done to it from one side.
struct MillPlan {
    Half half = Half::lower;
    bool outside = false;  ///< turned over about x, for what a case leaves out
    MillField field;
    std::vector<MillPin> pins;
    ReliefReport relief;
    MillPath path;

    [[nodiscard]] double depth_mm() const { return (field.top - field.lowest()) * field.step_mm; }
    /// Whether the machine has anything to do.
    [[nodiscard]] bool empty() const { return path.moves.empty(); }
};

struct MillPlans {
    std::vector<MillPlan> plans;  ///< lower, lid, then what is milled from outside
    bool no_room_for_pins = false;
};

/// Both halves' ways, or what forbids them (kind usage), see mill_pack().
[[nodiscard]] Result<MillPlans> mill_plans(const FoamDesign& design,
                                           const std::optional<MilledObject>& object,
                                           const MillOptions& options);

}  // namespace snug
