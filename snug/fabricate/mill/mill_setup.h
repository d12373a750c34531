#pragma once

#include <string>
#include <vector>

#include "snug/fabricate/mill/mill_plan.h"

namespace snug {

/// "lower.nc", "lid-outside.nc"
[[nodiscard]] std::string mill_file_name(const MillPlan& plan);
/// "lower-board.nc": holes in the board for the pins that the turned half lies on
[[nodiscard]] std::string mill_board_name(Piece piece);
/// "lower-labels.nc": the labels of items that lie in the piece, engraved by another cutter
[[nodiscard]] std::string mill_labels_name(Piece piece);
/// "cavity up", or "outer side up, cavity down"
[[nodiscard]] Message mill_side_up(const MillPlan& plan);
/// Where BACK is to the operator: "away from you" or "towards you"
[[nodiscard]] Message mill_back(const MillPlan& plan);

/// The set-up sheet: stock, cutter, feeds, the order of work, and each side from above with its depths, pins
/// and way round, on upright pages of this size.
[[nodiscard]] DrawingDocument mill_setup(const FoamDesign& design, const MillPlans& plans,
                                         const MillOptions& options, const std::vector<PackFigure>& figures,
                                         Vec2d page_mm);

}  // namespace snug
