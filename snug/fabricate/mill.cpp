#include "snug/fabricate/mill.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/fabricate/gcode.h"
#include "snug/fabricate/mill_plan.h"
#include "snug/fabricate/mill_setup.h"

namespace snug {
namespace {

std::vector<std::string> remarks(const MillPlan& plan, const MillOptions& options) {
    const Vec2d size = plan.field.size_mm();
    return {
        "Stock " + dimensions({size.x, size.y, plan.field.top_mm()}) + " mm, cavity side up",
        std::string("BACK ") + ((plan.half == Half::lower) != plan.outside ? "away from you" : "towards you"),
        "Flat cutter " + number(options.cutter_mm) + " mm, " + number(plan.depth_mm(), 1) + " mm deep",
        "X0 Y0 at the " + std::string(options.origin == MillOrigin::corner ? "near left corner" : "middle") +
            " of the stock, Z0 on its top",
        "Feeds and speeds are starting values: try them on waste"};
}

/// The board's holes that the turned halves lie on: as the holes lie after turning them over about x.
MillPath board_path(const MillPlan& lower, const MillOptions& options) {
    std::vector<MillPin> pins = lower.pins;
    for (MillPin& pin : pins) pin.at.y = lower.field.size_mm().y - pin.at.y;
    return mill_path(lower.field, {}, {}, pins, options);
}

void add_programs(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                  WorkshopPack& pack) {
    bool turned = false;
    for (const MillPlan& plan : plans.plans) {
        if (plan.empty()) continue;
        turned = turned || plan.outside;
        pack.files.push_back(text_file(
            "mill/" + mill_file_name(plan),
            grbl_program(plan.path, plan.field.size_mm(), options,
                         "Snug: " + design.object_name + ", " + mill_title(plan), remarks(plan, options))));
    }
    const MillPlan& lower = plans.plans.front();
    if (!turned || lower.pins.empty()) return;
    pack.files.push_back(
        text_file("mill/board.nc",
                  grbl_program(board_path(lower, options), lower.field.size_mm(), options,
                               "Snug: " + design.object_name + ", pins in the board for the outer sides",
                               {"X0 Y0 where the stock's near left corner will lie, Z0 on the board",
                                "Lay each half on its pins with the cavity down"})));
}

std::string stock_text(const MillPlan& plan) {
    const Vec2d size = plan.field.size_mm();
    if (plan.field.top == 0) return "none";
    return dimensions({size.x, size.y, plan.field.top_mm()}) + " mm";
}

void tell_figures(const MillPlans& plans, WorkshopPack& pack) {
    double minutes = 0, way = 0, deepest = 0, litres = 0;
    int passes = 0;
    for (const MillPlan& plan : plans.plans) {
        minutes += plan.path.minutes;
        way += plan.path.cut_mm;
        passes += plan.path.levels;
        deepest = std::max(deepest, plan.depth_mm());
        const Vec2d size = plan.field.size_mm();
        if (!plan.outside) litres += size.x * size.y * plan.field.top_mm() * 1e-6;
    }
    pack.figures = {{"Stock, lower", stock_text(plans.plans[0])},
                    {"Stock, lid", stock_text(plans.plans[1])},
                    {"Deepest pocket", number(deepest, 1) + " mm"},
                    {"Passes", grouped(static_cast<unsigned long long>(passes))},
                    {"Way of the cutter", number(way / 1000, 1) + " m"},
                    {"Time at these feeds", "about " + number(std::ceil(minutes), 0) + " minutes"}};
    pack.material.pieces = 2;
    pack.material.litres = litres;
}

void tell_round_corners(const MillPlans& plans, const MillOptions& options, WorkshopPack& pack) {
    double widest = 0, overcut = 0, left = 0;
    for (const MillPlan& plan : plans.plans) {
        widest = std::max(widest, plan.relief.widest_mm);
        overcut += plan.relief.overcut_mm3;
        left += plan.relief.left_mm3;
    }
    const auto cm3 = [](double mm3) { return number(mm3 * 1e-3, 1) + " cm3"; };
    pack.figures.push_back({"Extra gap in corners",
                            overcut > 0 ? "up to " + number(widest, 1) + " mm, " + cm3(overcut) : "none"});
    if (overcut <= 0 && left <= 0) return;
    pack.findings.push_back({Severity::note,
                             "round_corners",
                             "a round cutter of " + number(options.cutter_mm) + " mm leaves " + cm3(left) +
                                 " of foam in inside corners where the object does not reach" +
                                 (overcut > 0 ? ", and where it does takes up to " + number(widest, 1) +
                                                    " mm (" + cm3(overcut) + ") more than the blocks"
                                              : "") +
                                 "; a thinner cutter makes both less",
                             {}});
}

void tell_pins(const MillPlans& plans, const MillOptions& options, WorkshopPack& pack) {
    if (options.pin_mm == 0 || !plans.plans[0].pins.empty()) return;
    const std::string why =
        plans.no_room_for_pins
            ? "there is too little foam of full height for pins of " + number(options.pin_mm) + " mm"
            : "holes for pins of " + number(options.pin_mm) + " mm cannot be made with a cutter of " +
                  number(options.cutter_mm) + " mm";
    const bool turned = plans.plans.size() > 2;
    pack.findings.push_back({turned ? Severity::warning : Severity::note,
                             "no_pins",
                             why + ", so there are none: line the halves up by their edges, or choose others "
                                   "with --pin (0: none)",
                             {}});
}

}  // namespace

Result<WorkshopPack> mill_pack(const FoamDesign& design, const std::optional<MilledObject>& object,
                               const MillOptions& options) {
    const auto plans = mill_plans(design, object, options);
    if (!plans) return tl::unexpected(plans.error());
    WorkshopPack pack;
    add_programs(design, *plans, options, pack);
    tell_figures(*plans, pack);
    tell_round_corners(*plans, options, pack);
    tell_pins(*plans, options, pack);
    if (pack.files.empty())
        pack.findings.push_back(
            {Severity::note, "nothing_to_mill", "both halves are flat boards: there is nothing to mill", {}});
    pack.documents.push_back(mill_setup(design, *plans, options, pack.figures));
    return pack;
}

}  // namespace snug
