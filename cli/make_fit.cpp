#include "cli/make_fit.h"

#include <array>
#include <string_view>

#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/words/sides.h"

#include "cli/option_values.h"

namespace snug::cli {
namespace {

Result<void> take_notches(const FitArguments& a, FitOptions& fit) {
    if (!a.notches && !fit.notches && (a.notch_axis || a.notch_at))
        return fail(ErrorKind::usage, "--notch-axis and --notch-at belong to --notches");
    if (a.notches && *a.notches == "none") {
        fit.notches.reset();
        return {};
    }
    if (!a.notches && !fit.notches) return {};
    NotchOptions notches = fit.notches.value_or(NotchOptions{});
    if (a.notches) {
        const auto size = parse_notches("--notches", *a.notches);
        if (!size) return tl::unexpected(size.error());
        notches.width_mm = size->x;
        notches.depth_mm = size->y;
        notches.room_mm = size->z > 0 ? size->z : NotchOptions{}.room_mm;
    }
    if (a.notch_axis && *a.notch_axis != "y" && *a.notch_axis != "z" && *a.notch_axis != "auto")
        return fail(ErrorKind::usage,
                    fmt::format("--notch-axis takes y, z or auto, not {}", snug::quoted(*a.notch_axis)));
    if (a.notch_axis) {
        notches.axis.reset();
        if (*a.notch_axis != "auto") notches.axis = *a.notch_axis == "y" ? 1 : 2;
    }
    if (a.notch_at) {
        const auto at = parse_pair("--notch-at", *a.notch_at);
        if (!at) return tl::unexpected(at.error());
        notches.first_mm = at->x;
        notches.second_mm = at->y;
    }
    fit.notches = notches;
    return {};
}

std::string areas(const std::array<double, 3>& mm2) {
    return fmt::format("{}, {}, {} cm2", number(mm2[0] / 100, 0), number(mm2[1] / 100, 0),
                       number(mm2[2] / 100, 0));
}

}  // namespace

void add_fit_options(CLI::App& command, FitArguments& a) {
    command
        .add_option("--clearance", a.clearance,
                    "Grow the object by this on every side: one number, or X,Y,Z, or six: X,Y,Z for the "
                    "lower foam, then for the upper; negative squeezes it (0)")
        ->type_name("MM|X,Y,Z|SIX");
    command.add_option("--liner", a.liner, "Thickness of a cloth between object and foam, on top (0)")
        ->type_name("MM");
    command
        .add_option("--least-rib", a.least_rib,
                    "Cut away foam between cavities that is thinner than this (0: none)")
        ->type_name("MM");
    command
        .add_option("--notches", a.notches,
                    "Two recesses beside the object for the fingers: width x depth, and room outwards (25)")
        ->type_name("80x40[x25]|none");
    command
        .add_option("--notch-axis", a.notch_axis, "The axis along which they lie opposite each other (auto)")
        ->type_name("y|z|auto");
    command
        .add_option("--notch-at", a.notch_at,
                    "Their middles along the object's sides, from the middle of the space (auto)")
        ->type_name("MM[,MM]");
    command.add_flag("--cut-on-touch", a.cut_on_touch, "Also cut blocks that the object merely touches");
}

Result<void> take_fit(const FitArguments& a, Design& design) {
    if (a.clearance) {
        const auto clearance = parse_clearance("--clearance", *a.clearance);
        if (!clearance) return tl::unexpected(clearance.error());
        design.cut.clearance_mm = *clearance;
    }
    if (a.liner) design.cut.liner_mm = *a.liner;
    if (a.least_rib) design.fit.least_rib_mm = *a.least_rib;
    if (a.cut_on_touch) design.cut.cut_on_touch = true;
    return take_notches(a, design.fit);
}

Message notch_text(const Notch& notch) {
    const bool along_y = notch.side == kBack || notch.side == kFront;
    return say("summary.notch_at", {{"side", side_text(notch.side)},
                                    {"axis", along_y ? "z" : "y"},
                                    {"at", number(notch.at_mm, 1)},
                                    {"deep", number(notch.size_mm.x, 1)}});
}

Message bearing_text(const BearingReport& bearing, const Design& design) {
    const auto pressure = [&](double area_mm2) {
        const auto kpa = static_pressure_kpa(*design.workshop.mass_kg, area_mm2);
        return kpa ? number(*kpa, 1) : std::string("-");
    };
    std::vector<Message> at_rest;
    if (design.workshop.mass_kg) {
        const auto& lower = bearing.lower_mm2;
        at_rest.push_back(say("summary.at_rest", {{"kpa", pressure(lower[0]) + ", " + pressure(lower[1]) +
                                                              ", " + pressure(lower[2])}}));
        at_rest.push_back(design.fit.creep_kpa
                              ? say("summary.creep", {{"kpa", number(*design.fit.creep_kpa, 1)}})
                              : say("summary.creep_unknown"));
    }
    return say(
        "summary.bears_on",
        {{"below", areas(bearing.lower_mm2)}, {"above", areas(bearing.upper_mm2)}, {"at_rest", at_rest}});
}

}  // namespace snug::cli
