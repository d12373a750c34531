#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "snug/fabricate/mill/mill.h"
#include "snug/fabricate/mill/mill_path.h"

namespace snug {

/// One stock and what is done to it from one side.
struct MillPlan {
    Piece piece;
    bool outside = false;  ///< turned over about x, for what a case or a cavity below leaves out
    MillField field;
    std::vector<MillPin> pins;
    ReliefReport relief;
    MillPath path;
    /// The labels of items that lie in this side, engraved by another cutter after all else.
    std::vector<std::vector<Vec2d>> letters;
    MillPath engraving;
    double engraved_mm = 0;  ///< deep

    [[nodiscard]] double depth_mm() const { return (field.top - field.lowest()) * field.step_mm; }
    /// Whether the machine has anything to do.
    [[nodiscard]] bool empty() const { return path.moves.empty(); }
};

struct MillPlans {
    std::vector<MillPlan> plans;  ///< each piece, the lowest first, then what is milled from outside
    bool no_room_for_pins = false;

    /// Of the same piece from its cavity's side.
    [[nodiscard]] const MillPlan& own(const MillPlan& plan) const {
        return plans[static_cast<std::size_t>(plan.piece.index)];
    }
    [[nodiscard]] int pieces() const {
        return static_cast<int>(
            std::count_if(plans.begin(), plans.end(), [](const MillPlan& plan) { return !plan.outside; }));
    }
    /// Whether there is foam between layers.
    [[nodiscard]] bool layered() const { return plans.front().piece.count > 2; }
};

/// All pieces' ways, or what forbids them (kind usage), see mill_pack().
[[nodiscard]] Result<MillPlans> mill_plans(const FoamDesign& design,
                                           const std::optional<MilledObject>& object,
                                           const MillOptions& options);

}  // namespace snug
