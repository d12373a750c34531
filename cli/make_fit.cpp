#include "cli/make_fit.h"

#include <array>

#include <fmt/core.h>

#include "snug/base/text.h"

namespace snug::cli {
namespace {

std::string areas(const std::array<double, 3>& mm2) {
    return fmt::format("{}, {}, {} cm2", number(mm2[0] / 100, 0), number(mm2[1] / 100, 0),
                       number(mm2[2] / 100, 0));
}

}  // namespace

std::string notch_text(const Notch& notch) {
    const bool along_y = notch.side == kBack || notch.side == kFront;
    return fmt::format("{} at {} = {} mm, {} deep", side_name(notch.side), along_y ? "z" : "y",
                       number(notch.at_mm, 1), number(notch.size_mm.x, 1));
}

std::string bearing_text(const BearingReport& bearing, const Design& design) {
    std::string text = fmt::format("below {}, above {} once it sank 1, 3, 5 mm", areas(bearing.lower_mm2),
                                   areas(bearing.upper_mm2));
    const auto pressure = [&](double area_mm2) {
        const auto kpa = static_pressure_kpa(*design.workshop.mass_kg, area_mm2);
        return kpa ? number(*kpa, 1) : std::string("-");
    };
    if (design.workshop.mass_kg) {
        const auto& lower = bearing.lower_mm2;
        text += fmt::format("; at rest {}, {}, {} kPa", pressure(lower[0]), pressure(lower[1]),
                            pressure(lower[2]));
        text += design.fit.creep_kpa
                    ? fmt::format(" of {} kPa that the foam bears for long", number(*design.fit.creep_kpa, 1))
                    : std::string(" (what this foam bears for long is not known)");
    }
    return text + ". Drops were not checked";
}

}  // namespace snug::cli
