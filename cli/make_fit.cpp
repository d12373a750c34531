#include "cli/make_fit.h"

#include <array>

#include <fmt/core.h>

#include "snug/base/text.h"
#include "snug/words/sides.h"

namespace snug::cli {
namespace {

std::string areas(const std::array<double, 3>& mm2) {
    return fmt::format("{}, {}, {} cm2", number(mm2[0] / 100, 0), number(mm2[1] / 100, 0),
                       number(mm2[2] / 100, 0));
}

}  // namespace

Message notch_text(const Notch& notch) {
    const bool along_y = notch.side == kBack || notch.side == kFront;
    return say("summary.notch_at", {{"side", side_text(notch.side)},
                                    {"axis", along_y ? "z" : "y"},
                                    {"at", number(notch.at_mm, 1)},
                                    {"deep", number(notch.size_mm.x, 1)}});
}

Message bearing_text(const BearingReport& bearing, const Foams& foams, const Design& design, bool dropped) {
    const auto mass = mass_kg(design);
    const auto pressure = [&](double area_mm2) {
        const auto kpa = static_pressure_kpa(*mass, area_mm2);
        return kpa ? number(*kpa, 1) : std::string("-");
    };
    std::vector<Message> at_rest;
    if (mass) {
        const auto& lower = bearing.lower_mm2;
        at_rest.push_back(say("summary.at_rest", {{"kpa", pressure(lower[0]) + ", " + pressure(lower[1]) +
                                                              ", " + pressure(lower[2])}}));
        at_rest.push_back(design.fit.creep_kpa
                              ? say("summary.creep", {{"kpa", number(*design.fit.creep_kpa, 1)}})
                              : say("summary.creep_unknown"));
    }
    std::vector<Message> drops;
    if (!dropped) drops.push_back(say("summary.no_drops"));
    const std::string below = areas(bearing.lower_mm2);
    if (foams.open()) return say("summary.bears_in_tray", {{"below", below}, {"at_rest", at_rest}});
    return say(
        "summary.bears_on",
        {{"below", below}, {"above", areas(bearing.upper_mm2)}, {"at_rest", at_rest}, {"drops", drops}});
}

}  // namespace snug::cli
