#include "snug/fabricate/mill/mill.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "snug/base/text.h"
#include "snug/drawing/page_builder.h"
#include "snug/fabricate/mill/gcode.h"
#include "snug/fabricate/mill/mill_plan.h"
#include "snug/fabricate/mill/mill_setup.h"

namespace snug {
namespace {

std::string zero_text(const MillOptions& options, const std::string& of, const std::string& on) {
    return "X0 Y0 at the " +
           std::string(options.origin == MillOrigin::corner ? "near left corner" : "middle") + " of " + of +
           ", Z0 on " + on;
}

std::vector<std::string> remarks(const MillPlan& plan, const MillOptions& options) {
    const Vec2d size = plan.field.size_mm();
    return {"Stock " + dimensions({size.x, size.y, plan.field.top_mm()}) + " mm, " + mill_side_up(plan),
            std::string("BACK ") + mill_back(plan),
            "Flat cutter " + number(options.cutter_mm) + " mm, " + number(plan.depth_mm(), 1) + " mm deep",
            zero_text(options, "the stock", "its top"),
            "Feeds and speeds are starting values: try them on waste"};
}

/// The holes in the board for the pins that the turned half lies on: where its own come to lie when it is
/// turned over about x.
std::string board_program(const FoamDesign& design, const MillPlan& own, const MillPlan& outside,
                          const MillOptions& options) {
    std::vector<MillPin> pins = own.pins;
    for (MillPin& pin : pins) pin.at.y = own.field.size_mm().y - pin.at.y;
    return grbl_program(mill_path(own.field, {}, {}, pins, options), own.field.size_mm(), options,
                        {"BOARD below " + std::string(half_title(own.half)), design.object_name},
                        {"Holes for pins in the board, for " + mill_file_name(outside),
                         zero_text(options, "where the stock will lie", "the board"),
                         "Then lay the " + std::string(half_title(own.half)) +
                             " on the pins, cavity down, BACK " + mill_back(outside)});
}

void add_programs(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                  WorkshopPack& pack) {
    for (const MillPlan& plan : plans.plans) {
        if (plan.empty()) continue;
        pack.files.push_back(
            text_file("mill/" + mill_file_name(plan),
                      grbl_program(plan.path, plan.field.size_mm(), options,
                                   {mill_title(plan), design.object_name}, remarks(plan, options))));
        const MillPlan& own = plans.plans[plan.half == Half::lower ? 0 : 1];
        if (plan.outside && !own.pins.empty())
            pack.files.push_back(
                text_file("mill/" + mill_board_name(plan.half), board_program(design, own, plan, options)));
    }
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

/// One digit behind the point, rounded up: never less than it is, and never nothing where there is some.
std::string at_most(double value) {
    return number(std::ceil(value * 10 - 1e-9) / 10, 1);
}

void tell_round_corners(const MillPlans& plans, const MillOptions& options, WorkshopPack& pack) {
    double widest = 0, overcut = 0, left = 0;
    for (const MillPlan& plan : plans.plans) {
        widest = std::max(widest, plan.relief.widest_mm);
        overcut += plan.relief.overcut_mm3;
        left += plan.relief.left_mm3;
    }
    const std::string taken =
        "up to " + at_most(widest) + " mm wide, " + at_most(overcut * 1e-3) + " cm3 together";
    pack.figures.push_back({"Extra gap in corners", widest > 0 ? taken : "none"});
    if (widest <= 0 && left <= 0) return;
    std::string words = "a round cutter of " + number(options.cutter_mm) + " mm";
    if (left > 0)
        words += " leaves " + at_most(left * 1e-3) +
                 " cm3 of foam in inside corners where the object does not reach";
    if (left > 0 && widest > 0) words += ", and";
    if (widest > 0)
        words +=
            " takes foam beside the blocks where it must go beyond them to reach a corner (" + taken + ")";
    pack.findings.push_back(
        {Severity::note, "round_corners", words + "; a thinner cutter makes both less", {}});
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
                               const MillOptions& options, Vec2d page_mm) {
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
    pack.documents.push_back(mill_setup(design, *plans, options, pack.figures, page_mm));
    return pack;
}

}  // namespace snug
