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
#include "snug/words/pieces.h"
#include "snug/words/words.h"

namespace snug {
namespace {

std::string zero_text(const MillOptions& options, const std::string& of, const std::string& on) {
    return "X0 Y0 at the " +
           std::string(options.origin == MillOrigin::corner ? "near left corner" : "middle") + " of " + of +
           ", Z0 on " + on;
}

/// Controllers read ASCII alone, so that programs speak English.
std::string side_up(const MillPlan& plan) {
    return text(mill_side_up(plan), Language::english);
}
std::string back(const MillPlan& plan) {
    return text(mill_back(plan), Language::english);
}

std::vector<std::string> remarks(const MillPlan& plan, const MillOptions& options) {
    const Vec2d size = plan.field.size_mm();
    return {"Stock " + dimensions({size.x, size.y, plan.field.top_mm()}) + " mm, " + side_up(plan),
            "BACK " + back(plan),
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
    return grbl_program(
        mill_path(own.field, {}, {}, pins, options), own.field.size_mm(), options,
        {"BOARD below " + piece_title(own.piece), design.object_name},
        {"Holes for pins in the board, for " + mill_file_name(outside),
         zero_text(options, "where the stock will lie", "the board"),
         "Then lay the " + piece_title(own.piece) + " on the pins, cavity down, BACK " + back(outside)});
}

/// For another cutter, on the same stock as it lies.
std::string engraving_program(const FoamDesign& design, const MillPlan& plan, const MillOptions& options) {
    return grbl_program(plan.engraving, plan.field.size_mm(), options,
                        {"LABELS on " + piece_title(plan.piece), design.object_name},
                        {"After " + mill_file_name(plan) + ", the stock as it lies",
                         "A pointed cutter or one of 1 mm, " + number(plan.engraved_mm, 2) + " mm deep",
                         zero_text(options, "the stock", "its top") + " with this cutter"});
}

void add_programs(const FoamDesign& design, const MillPlans& plans, const MillOptions& options,
                  WorkshopPack& pack) {
    for (const MillPlan& plan : plans.plans) {
        if (plan.empty()) continue;
        pack.files.push_back(
            text_file("mill/" + mill_file_name(plan),
                      grbl_program(plan.path, plan.field.size_mm(), options,
                                   {piece_title(plan.piece) + ", " + side_up(plan), design.object_name},
                                   remarks(plan, options))));
        if (!plan.letters.empty())
            pack.files.push_back(
                text_file("mill/" + mill_labels_name(plan.piece), engraving_program(design, plan, options)));
        const MillPlan& own = plans.own(plan);
        if (plan.outside && !own.pins.empty())
            pack.files.push_back(
                text_file("mill/" + mill_board_name(plan.piece), board_program(design, own, plan, options)));
    }
}

Message stock_text(const MillPlan& plan) {
    const Vec2d size = plan.field.size_mm();
    if (plan.field.top == 0) return say("figure.none");
    return as_it_is(dimensions({size.x, size.y, plan.field.top_mm()}) + " mm");
}

void tell_figures(const MillPlans& plans, WorkshopPack& pack) {
    double minutes = 0, way = 0, deepest = 0, litres = 0;
    int passes = 0;
    for (const MillPlan& plan : plans.plans) {
        minutes += plan.path.minutes + plan.engraving.minutes;
        way += plan.path.cut_mm;
        passes += plan.path.levels;
        deepest = std::max(deepest, plan.depth_mm());
        const Vec2d size = plan.field.size_mm();
        if (!plan.outside) litres += size.x * size.y * plan.field.top_mm() * 1e-6;
    }
    for (const MillPlan& plan : plans.plans)
        if (!plan.outside)
            pack.figures.push_back(
                {piece_text(plan.piece, "figure.stock_lower", "figure.stock_middle", "figure.stock_lid"),
                 stock_text(plan)});
    const auto tell = [&](const char* label, Message value) {
        pack.figures.push_back({say(label), std::move(value)});
    };
    tell("figure.deepest_pocket", as_it_is(number(deepest, 1) + " mm"));
    tell("figure.passes", as_it_is(grouped(static_cast<unsigned long long>(passes))));
    tell("figure.way_of_cutter", as_it_is(number(way / 1000, 1) + " m"));
    tell("figure.time", say("figure.minutes", {{"minutes", number(std::ceil(minutes), 0)}}));
    pack.material.pieces = plans.pieces();
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
    const std::string widest_mm = at_most(widest), taken_cm3 = at_most(overcut * 1e-3),
                      left_cm3 = at_most(left * 1e-3), cutter_mm = number(options.cutter_mm);
    pack.figures.push_back(
        {say("figure.corners"),
         widest > 0 ? say("figure.corner_gap", {{"widest_mm", widest_mm}, {"taken_cm3", taken_cm3}})
                    : say("figure.none")});
    const auto tell = [&](Message message) { pack.findings.push_back({Severity::note, std::move(message)}); };
    if (left > 0 && widest > 0)
        tell(say("round_corners/both", {{"cutter_mm", cutter_mm},
                                        {"left_cm3", left_cm3},
                                        {"widest_mm", widest_mm},
                                        {"taken_cm3", taken_cm3}}));
    else if (left > 0)
        tell(say("round_corners/left", {{"cutter_mm", cutter_mm}, {"left_cm3", left_cm3}}));
    else if (widest > 0)
        tell(say("round_corners",
                 {{"cutter_mm", cutter_mm}, {"widest_mm", widest_mm}, {"taken_cm3", taken_cm3}}));
}

void tell_pins(const MillPlans& plans, const MillOptions& options, WorkshopPack& pack) {
    if (options.pin_mm == 0 || !plans.plans[0].pins.empty()) return;
    const std::string pin_mm = number(options.pin_mm);
    const bool turned = static_cast<int>(plans.plans.size()) > plans.pieces();
    pack.findings.push_back(
        {turned ? Severity::warning : Severity::note,
         plans.no_room_for_pins
             ? say("no_pins", {{"pin_mm", pin_mm}})
             : say("no_pins/cutter", {{"pin_mm", pin_mm}, {"cutter_mm", number(options.cutter_mm)}})});
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
    if (pack.files.empty()) pack.findings.push_back({Severity::note, say("nothing_to_mill")});
    pack.documents.push_back(mill_setup(design, *plans, options, pack.figures, page_mm));
    return pack;
}

}  // namespace snug
