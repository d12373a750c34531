#include "snug/fabricate/mill/mill_plan.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "snug/base/text.h"
#include "snug/design/option_list.h"
#include "snug/fabricate/mill/mill_allowed.h"
#include "snug/words/pieces.h"

namespace snug {
namespace {

constexpr double kCellsInRadius = 4;     // fine cells that tell what the cutter leaves
constexpr double kPinFit = 1e-6;         // mm
constexpr double kEngravedDepth = 1;     // mm, or half of thinner foam
constexpr double kFluteRounding = 1e-6;  // mm

Message name_of(const MillPlan& plan) {
    if (!plan.outside) return half_of(plan.piece);
    return say(plan.piece.middle() ? "mill.under_side" : "mill.outer_side", {{"half", half_of(plan.piece)}});
}

/// A cutter that enters some pockets is enough: reliefs take what the others need.
std::optional<Error> too_wide(const std::vector<MillPlan>& plans, const MillOptions& options) {
    double widest = 0;
    bool anything = false;
    for (const MillPlan& plan : plans) {
        if (plan.field.lowest() >= plan.field.top) continue;
        anything = true;
        const CentreLines lines(plan.field, plan.field.top - 1, options.cutter_mm / 2);
        if (!level_pass(lines, options.stepover * options.cutter_mm).empty()) return {};
        widest = std::max(widest, widest_cutter_mm(plan.field));
    }
    if (!anything) return {};
    return Error{ErrorKind::usage, say("mill.wide_cutter", {{"cutter_mm", number(options.cutter_mm)},
                                                            {"widest_mm", number(widest, 1)}})};
}

std::optional<Error> too_deep(const std::vector<MillPlan>& plans, const MillOptions& options) {
    for (const MillPlan& plan : plans) {
        const double depth = plan.depth_mm();
        if (depth <= options.flute_mm + kFluteRounding) continue;
        return Error{ErrorKind::usage, say("mill.short_flute", {{"flute_mm", number(options.flute_mm)},
                                                                {"half", name_of(plan)},
                                                                {"depth_mm", number(depth, 1)}})};
    }
    return {};
}

/// Passes, reliefs and moves of one side.
Result<void> work_out(MillPlan& plan, const FoamDesign& design, const std::optional<MilledObject>& object,
                      const MillOptions& options) {
    const double radius = options.cutter_mm / 2;
    const std::vector<LevelPass> passes =
        level_passes(plan.field, radius, options.stepover * options.cutter_mm);
    CarvedStock stock(plan.field, radius, radius / kCellsInRadius);
    if (length(stock.cell_mm()) > radius)
        return fail(ErrorKind::usage,
                    say("mill.too_many_columns", {{"cutter_mm", number(options.cutter_mm)}}));
    for (const LevelPass& pass : passes)
        for (const std::vector<CutLine>* lines : {&pass.fill, &pass.walls})
            for (const CutLine& line : *lines) stock.cut(line, pass.level);
    const Grid<int> allowed = plan.outside ? allowed_outside(design, plan.piece, plan.field, stock, object)
                                           : allowed_heights(design, plan.piece, plan.field, stock, object);
    plan.relief = relieve(plan.field, passes, allowed, radius, stock);
    plan.path = mill_path(plan.field, passes, plan.relief.reliefs, plan.pins, options);
    if (!plan.path.too_long) return {};
    return fail(ErrorKind::usage,
                say("mill.too_many_moves", {{"half", name_of(plan)}, {"most", kMostMoves}}));
}

/// Each piece from its cavity's side, then from the other one where foam is left out there. What lies between
/// two layers meets another piece on both.
std::vector<MillPlan> all_sides(const FoamDesign& design, const MillOptions& options) {
    std::vector<MillPlan> plans, outside;
    const double step_mm = wanted_step_down_mm(options);
    for (const Piece piece : design.foams.all()) {
        plans.push_back({piece, false, mill_field(design, piece, step_mm), {}, {}, {}, {}, {}, 0});
        MillPlan other{piece, true, mill_outside(design, piece, step_mm), {}, {}, {}, {}, {}, 0};
        if (piece.middle() || other.field.lowest() < other.field.top) outside.push_back(std::move(other));
    }
    plans.insert(plans.end(), std::make_move_iterator(outside.begin()),
                 std::make_move_iterator(outside.end()));
    return plans;
}

void put_pins(MillPlans& all, const MillOptions& options) {
    std::vector<MillPlan*> plans;
    std::vector<PinnedSide> sides;
    for (MillPlan& plan : all.plans) {
        if (plan.outside && !plan.piece.middle()) continue;
        plans.push_back(&plan);
        sides.push_back({plan.field, plan.outside != (plan.piece.half() == Half::lid), plan.piece.middle()});
    }
    MillPins pins = mill_pins(sides, options.pin_mm, options.flute_mm);
    all.no_room_for_pins = pins.no_room;
    for (std::size_t i = 0; i < plans.size(); ++i) plans[i]->pins = std::move(pins.sides[i]);
}

/// Which side they lie in is cavity up, and y runs away from the operator, BACK being there.
void put_labels(MillPlan& plan, std::span<const ItemLabel> labels, const MillOptions& options) {
    if (plan.outside) return;
    plan.engraved_mm = kEngravedDepth;
    for (const ItemLabel& label : labels) {
        if (label.layer != plan.piece.index + 1) continue;
        plan.engraved_mm = std::min(plan.engraved_mm, label.foam_mm / 2);
        for (std::vector<Vec2d>& line : label_lines(label)) {
            for (Vec2d& p : line) p.y = plan.field.size_mm().y - p.y;
            plan.letters.push_back(std::move(line));
        }
    }
    if (!plan.letters.empty())
        plan.engraving = engraving_path(plan.field, plan.letters, plan.engraved_mm, options);
}

}  // namespace

Result<MillPlans> mill_plans(const FoamDesign& design, const std::optional<MilledObject>& object,
                             const MillOptions& options) {
    if (auto problem = out_of_range(options)) return fail(ErrorKind::usage, std::move(problem->message));
    MillPlans result{all_sides(design, options), false};
    std::vector<MillPlan>& plans = result.plans;
    if (auto error = too_wide(plans, options)) return tl::unexpected(std::move(*error));
    if (auto error = too_deep(plans, options)) return tl::unexpected(std::move(*error));
    if (options.pin_mm >= options.cutter_mm - kPinFit) put_pins(result, options);
    for (MillPlan& plan : plans) {
        if (auto done = work_out(plan, design, object, options); !done) return tl::unexpected(done.error());
        put_labels(plan, design.labels, options);
    }
    return result;
}

}  // namespace snug
